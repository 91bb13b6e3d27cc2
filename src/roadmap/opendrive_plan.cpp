// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive_plan.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "roadmap/lane_strips.hpp"

namespace lanefuse {
namespace {

constexpr double kKnotDistance = 10;        // [m]
constexpr double kShortestOverhang = 0.01;  // [m]
constexpr double kLongestOverhang = 100;    // [m]
constexpr double kFarOff = 300;             // [m]

std::vector<Eigen::Vector2d> evenly(const MapBoundary& boundary) {
  std::vector<double> stations = {0};
  for (std::size_t i = 1; i < boundary.points.size(); ++i) {
    stations.push_back(stations.back() + (boundary.points[i] - boundary.points[i - 1]).head<2>().norm());
  }
  const int pieces = std::max(1, static_cast<int>(std::lround(stations.back() / kKnotDistance)));
  std::vector<Eigen::Vector2d> knots;
  std::size_t at = 1;
  for (int i = 0; i <= pieces; ++i) {
    const double station = stations.back() * i / pieces;
    while (at + 1 < stations.size() && stations[at] < station) ++at;
    const double gap = stations[at] - stations[at - 1];
    const double share = gap > 0 ? (station - stations[at - 1]) / gap : 0;  // points may repeat
    knots.push_back(
        (boundary.points[at - 1] + share * (boundary.points[at] - boundary.points[at - 1])).head<2>());
  }
  return knots;
}

std::vector<double> headings(const std::vector<Eigen::Vector2d>& knots) {
  std::vector<double> headings;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const Eigen::Vector2d along = knots[std::min(i + 1, knots.size() - 1)] - knots[i == 0 ? 0 : i - 1];
    headings.push_back(std::atan2(along.y(), along.x()));
  }
  return headings;
}

/// The cubic from one pose to another that leaves and arrives in their headings.
PlanElement curve_between(const Pose2& from, const Pose2& to, double station) {
  const Pose2 there = from.inverse() * to;
  const double reach = std::hypot(there.x, there.y);
  const double end_u = reach * std::cos(there.heading);
  const double end_v = reach * std::sin(there.heading);
  CubicPiece piece;
  piece.u = {0, reach, 3 * there.x - 2 * reach - end_u, reach + end_u - 2 * there.x};
  piece.v = {0, 0, 3 * there.y - end_v, end_v - 2 * there.y};
  double length = 0;
  constexpr int kSteps = 32;
  for (int i = 0; i < kSteps; ++i) {
    const double p = (i + 0.5) / kSteps;
    length += std::hypot(piece.u.slope_at(p), piece.v.slope_at(p)) / kSteps;
  }
  piece.parameter_per_metre = 1 / length;
  return {station, from, length, piece};
}

/// How far boundaries reach out before the first pose, or after the last. What ends far off ends elsewhere.
double overhang(const std::vector<const MapBoundary*>& boundaries, const Pose2& end, int direction) {
  double farthest = 0;
  const Pose2 to_end = end.inverse();
  for (const MapBoundary* boundary : boundaries) {
    const Eigen::Vector3d& point = direction > 0 ? boundary->points.back() : boundary->points.front();
    const Eigen::Vector2d there = to_end * Eigen::Vector2d(point.head<2>());
    if (there.norm() <= kFarOff) farthest = std::max(farthest, direction * there.x());
  }
  return farthest;
}

std::string text_of(const ClothoidPiece& piece, double length) {
  if (piece.curvature_rate != 0) {
    return fmt::format(R"(<spiral curvStart="{:.12g}" curvEnd="{:.12g}"/>)", piece.curvature,
                       piece.curvature + piece.curvature_rate * length);
  }
  if (piece.curvature != 0) return fmt::format(R"(<arc curvature="{:.12g}"/>)", piece.curvature);
  return "<line/>";
}

std::string text_of(const CubicPiece& piece, double /*length*/) {
  const Cubic& u = piece.u;
  const Cubic& v = piece.v;
  return fmt::format(R"(<paramPoly3 pRange="normalized" aU="{:.12g}" bU="{:.12g}" cU="{:.12g}" dU="{:.12g}")"
                     R"( aV="{:.12g}" bV="{:.12g}" cV="{:.12g}" dV="{:.12g}"/>)",
                     u.a, u.b, u.c, u.d, v.a, v.b, v.c, v.d);
}

std::string text_of(const GraphPiece& piece, double /*length*/) {
  return fmt::format(R"(<poly3 a="{:.12g}" b="{:.12g}" c="{:.12g}" d="{:.12g}"/>)", piece.v.a, piece.v.b,
                     piece.v.c, piece.v.d);
}

}  // namespace

PlanView exact_plan_view(const ExactPlan& plan) {
  std::vector<PlanElement> elements;
  Pose2 pose = plan.start;
  double station = 0;
  for (const ExactPlan::Piece& piece : plan.pieces) {
    const ClothoidPiece shape{piece.curvature, piece.curvature_rate};
    elements.push_back({station, pose, piece.length, shape});
    station += piece.length;
    pose = PlanView({elements.back()}).pose(station);
  }
  return PlanView(std::move(elements));
}

PlanView smooth_plan_view(const std::vector<const MapBoundary*>& boundaries, const std::string& place) {
  const MapBoundary& longest = **std::max_element(
      boundaries.begin(), boundaries.end(),
      [](const auto* a, const auto* b) { return arc_length(a->points) < arc_length(b->points); });
  const std::vector<Eigen::Vector2d> knots = evenly(longest);
  const std::vector<double> heading = headings(knots);
  const auto pose = [&](std::size_t i) { return Pose2{knots[i].x(), knots[i].y(), heading[i]}; };
  const double before = overhang(boundaries, pose(0), -1);
  const double after = overhang(boundaries, pose(knots.size() - 1), 1);
  if (std::max(before, after) > kLongestOverhang) {
    throw input_error(fmt::format("{}, boundary {}", place, longest.id),
                      "is the longest of its road and does not run along all of it",
                      "OpenDRIVE cannot tell such a road; write Lanelet2 or GeoJSON");
  }
  std::vector<PlanElement> elements;
  double station = 0;
  if (before > kShortestOverhang) {
    elements.push_back({0, pose(0) * Pose2{-before, 0, 0}, before, ClothoidPiece{}});
    station = before;
  }
  for (std::size_t i = 1; i < knots.size(); ++i) {
    elements.push_back(curve_between(pose(i - 1), pose(i), station));
    station += elements.back().length;
  }
  if (after > kShortestOverhang)
    elements.push_back({station, pose(knots.size() - 1), after, ClothoidPiece{}});
  return PlanView(std::move(elements));
}

std::string plan_view_text(const PlanView& plan) {
  std::string text = "    <planView>\n";
  for (const PlanElement& element : plan.elements()) {
    const std::string shape =
        std::visit([&](const auto& piece) { return text_of(piece, element.length); }, element.shape);
    text += fmt::format(
        R"(      <geometry s="{:.12g}" x="{:.12g}" y="{:.12g}" hdg="{:.12g}" length="{:.12g}">{}</geometry>)"
        "\n",
        element.station, element.begin.x, element.begin.y, element.begin.heading, element.length, shape);
  }
  return text + "    </planView>\n";
}

}  // namespace lanefuse
