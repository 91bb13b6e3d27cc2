// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/moved_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/lane_description.hpp"

namespace lanefuse {
namespace {

bool lies_on_its_clothoid(const Boundary& boundary) {
  constexpr double kRounding = 1e-9;  // [m]
  return std::all_of(boundary.points.begin(), boundary.points.end(), [&](const BoundaryPoint& point) {
    return std::abs(point.y - boundary.clothoid.y(point.x)) < kRounding;
  });
}

BoundaryPoint between(const BoundaryPoint& a, const BoundaryPoint& b, double x) {
  const double f = (x - a.x) / (b.x - a.x);
  return {x, a.y + f * (b.y - a.y), a.sigma + f * (b.sigma - a.sigma),
          a.protection + f * (b.protection - a.protection)};
}

/// The line through the points, taken anew where the new frame's x is a whole number of steps from its begin.
std::vector<BoundaryPoint> moved_points(const std::vector<BoundaryPoint>& points, const Pose2& new_from_old) {
  std::vector<BoundaryPoint> line;
  for (BoundaryPoint point : points) {
    const Eigen::Vector2d place = new_from_old * Eigen::Vector2d(point.x, point.y);
    point.x = place.x();
    point.y = place.y();
    if (line.empty() || point.x > line.back().x) line.push_back(point);
  }
  std::vector<BoundaryPoint> even;
  for (std::size_t i = 1; i < line.size(); ++i) {
    for (double x = line.front().x + kPointSpacing * static_cast<double>(even.size()); x <= line[i].x;
         x += kPointSpacing)
      even.push_back(between(line[i - 1], line[i], x));
  }
  return even;
}

Boundary moved_by(const Boundary& boundary, const Pose2& old_from_new) {
  Boundary moved = boundary;
  moved.clothoid = transform(boundary.clothoid, old_from_new);
  moved.range_begin -= old_from_new.x;
  moved.range_end -= old_from_new.x;
  if (boundary.points.size() < 2 || lies_on_its_clothoid(boundary)) {
    sample_points(moved);
    return moved;
  }
  moved.points = moved_points(boundary.points, old_from_new.inverse());
  if (moved.points.empty()) return moved;
  moved.range_begin = moved.points.front().x;
  moved.range_end = std::max(moved.range_end, moved.points.back().x);
  return moved;
}

}  // namespace

LaneEstimate moved_by(const LaneEstimate& estimate, double seconds) {
  const Pose2 old_from_new = constant_turn(estimate.speed, estimate.yaw_rate, seconds);
  LaneEstimate moved = estimate;
  moved.time += from_seconds(seconds);
  for (Boundary& boundary : moved.boundaries) boundary = moved_by(boundary, old_from_new);
  describe_lanes(moved);
  return moved;
}

DebugView moved_by(const DebugView& debug, const Pose2& old_from_new) {
  const Pose2 new_from_old = old_from_new.inverse();
  DebugView moved = debug;
  for (FusedFeature& fused : moved.features) {
    Feature& feature = fused.feature;
    const Pose2 pose = new_from_old * Pose2{feature.x, feature.y, feature.heading};
    feature.x = pose.x;
    feature.y = pose.y;
    feature.heading = pose.heading;
    feature.covariance = rotate_covariance(feature.covariance, new_from_old.heading);
  }
  for (SwitchState& edge : moved.switches) {
    edge.from = new_from_old * edge.from;
    edge.to = new_from_old * edge.to;
  }
  if (moved.base_clothoid) moved.base_clothoid = transform(*moved.base_clothoid, old_from_new);
  return moved;
}

}  // namespace lanefuse
