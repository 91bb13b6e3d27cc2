// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/straight_road.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "camera/bright_bars.hpp"

namespace lanefuse {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kSteepest = 5;  ///< slope: five camera heights to the side
constexpr double kBin = 0.05;
constexpr std::size_t kBins = static_cast<std::size_t>(2 * kSteepest / kBin);

/// How many points lie on the lines of each slope through one point.
using Votes = std::array<int, kBins>;

Votes votes_at(const Points& points, const Eigen::Vector2d& vanishing, double nearest) {
  Votes votes{};
  for (const Eigen::Vector2d& p : points) {
    const double down = p.y() - vanishing.y();
    if (down < nearest) continue;
    const double bin = ((p.x() - vanishing.x()) / down + kSteepest) / kBin;
    if (bin >= 0 && bin < static_cast<double>(kBins)) ++votes[static_cast<std::size_t>(bin)];
  }
  return votes;
}

/// Lines that share a vanishing point pile their votes up; everything else spreads them.
double sharpness(const Votes& votes) {
  double sum = 0;
  for (const int n : votes) sum += static_cast<double>(n) * n;
  return sum;
}

Eigen::Vector2d vote_for_vanishing(const Points& points, const StraightRoadConfig& config) {
  constexpr double kStep = 0.004;
  const int steps = static_cast<int>(config.largest_angle / kStep);
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double best_score = -1;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Eigen::Vector2d candidate(j * kStep, i * kStep);
      const double score = sharpness(votes_at(points, candidate, config.nearest_horizon));
      if (score > best_score) {
        best_score = score;
        best = candidate;
      }
    }
  }
  return best;
}

/// The slope nearest to straight ahead, on one side, that has half as many votes as that side's strongest.
std::optional<double> nearest_line(const Votes& votes, bool to_the_right, int fewest) {
  constexpr double kNearest = 0.2;
  constexpr double kFurthest = 3;
  // A line's votes may be split between two bins.
  const auto count = [&](int step) {
    const double slope = (to_the_right ? 1 : -1) * (kNearest + step * kBin);
    const auto bin = static_cast<std::size_t>((slope + kSteepest) / kBin);
    return std::pair(votes[bin] + votes[bin + 1], slope + kBin / 2);
  };
  const int steps = static_cast<int>((kFurthest - kNearest) / kBin);
  int most = 0;
  for (int i = 0; i < steps; ++i) most = std::max(most, count(i).first);
  const int enough = std::max(fewest, most / 2);
  for (int i = 0; i + 1 < steps; ++i) {
    if (count(i).first >= enough && count(i).first >= count(i + 1).first) return count(i).second;
  }
  return {};
}

/// right = offset + slope * down
struct Line {
  double offset = 0;
  double slope = 0;
  [[nodiscard]] double at(double down) const { return offset + slope * down; }
};

Line fit(const Points& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Eigen::Vector2d& p : points) {
    n += 1;
    x += p.y();
    y += p.x();
    xx += p.y() * p.y();
    xy += p.y() * p.x();
  }
  const double slope = (n * xy - x * y) / std::max(n * xx - x * x, 1e-12);
  return {(y - slope * x) / n, slope};
}

Points near(const Line& line, const Points& points, double horizon, double gate) {
  Points found;
  for (const Eigen::Vector2d& p : points) {
    if (p.y() > horizon && std::abs(p.x() - line.at(p.y())) < gate) found.push_back(p);
  }
  return found;
}

bool is_long(const Points& points, int fewest) {
  constexpr double kShortest = 0.05;  // down over depth
  if (points.size() < static_cast<std::size_t>(fewest)) return false;
  const auto [first, last] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
  return last->y() - first->y() > kShortest;
}

/// Fits both lines anew to what is near them, nearer from time to time.
std::optional<StraightRoadView> refine(const Points& points, Line left, Line right, double focal,
                                       const StraightRoadConfig& config) {
  StraightRoadView view;
  for (const double gate_px : {8.0, 5.0, 3.0, 3.0, 2.5, 2.5}) {
    const double turn = right.slope - left.slope;
    if (!(turn > 0.3)) return {};
    const double down = (left.offset - right.offset) / turn;
    view.vanishing = {left.at(down), down};
    if (!(view.vanishing.cwiseAbs().maxCoeff() <= config.largest_angle)) return {};
    const double horizon = down + config.nearest_horizon;
    view.left = near(left, points, horizon, gate_px / focal);
    view.right = near(right, points, horizon, gate_px / focal);
    if (!is_long(view.left, config.fewest_rows) || !is_long(view.right, config.fewest_rows)) return {};
    left = fit(view.left);
    right = fit(view.right);
  }
  view.left_slope = left.slope;
  view.right_slope = right.slope;
  return view;
}

}  // namespace

std::optional<StraightRoadView> find_straight_road(const ImageView& image, const CameraModel& camera,
                                                   const StraightRoadConfig& config) {
  Points points;
  for (const BrightBar& bar : find_bright_bars(image, config.contrast)) {
    points.push_back(camera.direction({(bar.left + bar.right) / 2, static_cast<double>(bar.row)}));
  }
  const Eigen::Vector2d vanishing = vote_for_vanishing(points, config);
  const Votes votes = votes_at(points, vanishing, config.nearest_horizon);
  const auto left = nearest_line(votes, false, config.fewest_rows);
  const auto right = nearest_line(votes, true, config.fewest_rows);
  if (!left || !right) return {};
  const auto through = [&](double slope) { return Line{vanishing.x() - slope * vanishing.y(), slope}; };
  return refine(points, through(*left), through(*right), camera.intrinsics().fx, config);
}

}  // namespace lanefuse
