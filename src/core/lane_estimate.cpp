// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/lane_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {

const Boundary* find_boundary(const LaneEstimate& estimate, std::uint64_t id) {
  const auto found = std::find_if(estimate.boundaries.begin(), estimate.boundaries.end(),
                                  [id](const Boundary& boundary) { return boundary.id == id; });
  return found == estimate.boundaries.end() ? nullptr : &*found;
}

const Lane* find_lane(const LaneEstimate& estimate, std::uint64_t id) {
  const auto found = std::find_if(estimate.lanes.begin(), estimate.lanes.end(),
                                  [id](const Lane& lane) { return lane.id == id; });
  return found == estimate.lanes.end() ? nullptr : &*found;
}

const Lane* ego_lane(const LaneEstimate& estimate) {
  for (const Lane& lane : estimate.lanes) {
    const Boundary* left = find_boundary(estimate, lane.left_boundary);
    const Boundary* right = find_boundary(estimate, lane.right_boundary);
    if (left && right && left->clothoid.lateral_offset > 0 && right->clothoid.lateral_offset <= 0)
      return &lane;
  }
  return nullptr;
}

void sample_points(Boundary& boundary) {
  boundary.points.clear();
  for (double x = boundary.range_begin; x <= boundary.range_end; x += kPointSpacing) {
    const Eigen::RowVector4d row = lateral_jacobian(x);
    const double variance = row * boundary.covariance * row.transpose();
    boundary.points.push_back({x, boundary.clothoid.y(x), std::sqrt(std::max(0.0, variance))});
  }
}

}  // namespace lanefuse
