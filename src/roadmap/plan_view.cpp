// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/plan_view.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {
namespace {

// Gauss-Legendre of five nodes: exact to 1e-12 of a panel's length where its heading turns by less than 0.2
// rad.
constexpr std::array<double, 5> kNodes = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                                          0.9061798459386640};
constexpr std::array<double, 5> kWeights = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                            0.4786286704993665, 0.2369268850561891};
constexpr double kPanelTurn = 0.2;  // [rad]
constexpr double kMostPanels = 1000;

Pose2 pose_on(const ClothoidPiece& piece, double s) {
  const auto heading = [&piece](double at) { return at * (piece.curvature + at * piece.curvature_rate / 2); };
  const double turn = std::abs(piece.curvature * s) + std::abs(piece.curvature_rate * s * s / 2);
  const int panels = static_cast<int>(std::min(kMostPanels, 1 + std::floor(turn / kPanelTurn)));
  const double half = s / panels / 2;
  Pose2 pose{0, 0, heading(s)};
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double along = heading(half * (2 * panel + 1 + kNodes[i]));
      pose.x += half * kWeights[i] * std::cos(along);
      pose.y += half * kWeights[i] * std::sin(along);
    }
  }
  return pose;
}

Pose2 pose_on(const CubicPiece& piece, double s) {
  const double p = s * piece.parameter_per_metre;
  return {piece.u.at(p), piece.v.at(p), std::atan2(piece.v.slope_at(p), piece.u.slope_at(p))};
}

/// The x at which the graph is s long.
double abscissa(const Cubic& v, double s) {
  double x = 0;
  constexpr int kSteps = 64;
  const double step = s / kSteps;
  const auto share = [&v](double at) { return 1 / std::hypot(1, v.slope_at(at)); };
  for (int i = 0; i < kSteps; ++i) x += step * share(x + step / 2 * share(x));  // midpoint rule
  return x;
}

Pose2 pose_on(const GraphPiece& piece, double s) {
  const double x = abscissa(piece.v, s);
  return {x, piece.v.at(x), std::atan(piece.v.slope_at(x))};
}

}  // namespace

PlanView::PlanView(std::vector<PlanElement> elements) : elements_(std::move(elements)) {
  assert(!elements_.empty());
}

Pose2 PlanView::pose(double station) const {
  const auto after = std::upper_bound(elements_.begin() + 1, elements_.end(), station,
                                      [](double at, const PlanElement& e) { return at < e.station; });
  const PlanElement& element = *(after - 1);
  const double s = station - element.station;
  return element.begin * std::visit([s](const auto& piece) { return pose_on(piece, s); }, element.shape);
}

double PlanView::end() const { return elements_.back().station + elements_.back().length; }

}  // namespace lanefuse
