// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/lane_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

/// Calls `between(a, b, fraction)` with the points around x; false where x is beyond the points.
template <typename Between>
bool at_points(const Boundary& boundary, double x, Between&& between) {
  const std::vector<BoundaryPoint>& points = boundary.points;
  if (points.size() < 2 || x < points.front().x || x > points.back().x) return false;
  const auto last = static_cast<std::ptrdiff_t>(points.size()) - 2;
  const auto i = std::min(last, static_cast<std::ptrdiff_t>((x - points.front().x) / kPointSpacing));
  const BoundaryPoint& a = points[static_cast<std::size_t>(i)];
  const BoundaryPoint& b = points[static_cast<std::size_t>(i + 1)];
  between(a, b, (x - a.x) / (b.x - a.x));
  return true;
}

double clothoid_sigma(const Boundary& boundary, double x) {
  const Eigen::RowVector4d row = lateral_jacobian(x);
  const double variance = row * boundary.covariance * row.transpose();
  return std::sqrt(std::max(0.0, variance));
}

}  // namespace

double lateral_at(const Boundary& boundary, double x) {
  double y = 0;
  const bool found = at_points(boundary, x, [&y](const BoundaryPoint& a, const BoundaryPoint& b, double f) {
    y = a.y + f * (b.y - a.y);
  });
  return found ? y : boundary.clothoid.y(x);
}

double sigma_at(const Boundary& boundary, double x) {
  double sigma = 0;
  const bool found =
      at_points(boundary, x, [&sigma](const BoundaryPoint& a, const BoundaryPoint& b, double f) {
        sigma = a.sigma + f * (b.sigma - a.sigma);
      });
  return found ? sigma : clothoid_sigma(boundary, x);
}

double protection_at(const Boundary& boundary, double x) {
  double protection = 0;
  at_points(boundary, x, [&protection](const BoundaryPoint& a, const BoundaryPoint& b, double f) {
    if (a.protection > 0 && b.protection > 0) protection = a.protection + f * (b.protection - a.protection);
  });
  return protection;
}

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
    boundary.points.push_back({x, boundary.clothoid.y(x), clothoid_sigma(boundary, x)});
  }
}

}  // namespace lanefuse
