// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/lane_description.hpp"

#include <algorithm>
#include <cmath>

#include "core/boundary_curve.hpp"

namespace lanefuse {
namespace {

LanePoint middle_at(const Boundary& left, const Boundary& right, double x) {
  const CurveShape of_left = shape_at(left, x);
  const CurveShape of_right = shape_at(right, x);
  const double slope = (of_left.slope + of_right.slope) / 2;
  const double stretch = std::sqrt(1 + slope * slope);  // of a step along the lane to one along x
  const double y_left = lateral_at(left, x);
  const double y_right = lateral_at(right, x);
  const double sigma_left = sigma_at(left, x);
  const double sigma_right = sigma_at(right, x);
  LanePoint point;
  point.x = x;
  point.y = (y_left + y_right) / 2;
  point.heading = std::atan(slope);
  point.curvature = (of_left.bend + of_right.bend) / 2 / (stretch * stretch * stretch);
  point.width = (y_left - y_right) / stretch;
  point.sigma = (sigma_left + sigma_right) / 2;
  point.width_sigma = std::hypot(sigma_left, sigma_right);
  return point;
}

void describe(const LaneEstimate& estimate, Lane& lane) {
  lane.centre.clear();
  const Boundary* left = find_boundary(estimate, lane.left_boundary);
  const Boundary* right = find_boundary(estimate, lane.right_boundary);
  if (!left || !right) {
    lane.range_begin = lane.range_end = lane.confidence = 0;
    return;
  }
  lane.confidence = std::min(left->confidence, right->confidence);
  lane.range_begin = std::max(left->range_begin, right->range_begin);
  lane.range_end = std::max(lane.range_begin, std::min(left->range_end, right->range_end));
  if (!(lane.range_end > lane.range_begin)) return;
  const auto count = static_cast<int>((lane.range_end - lane.range_begin) / kLanePointSpacing) + 1;
  for (int i = 0; i < count; ++i)
    lane.centre.push_back(middle_at(*left, *right, lane.range_begin + i * kLanePointSpacing));
}

}  // namespace

void describe_lanes(LaneEstimate& estimate) {
  for (Lane& lane : estimate.lanes) describe(estimate, lane);
}

}  // namespace lanefuse
