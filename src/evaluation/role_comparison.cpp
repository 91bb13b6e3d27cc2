// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/role_comparison.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

bool reaches(const Boundary& boundary, double x) {
  return boundary.range_begin <= x && x <= boundary.range_end;
}

/// The sigma that the boundary states at `x`, between its points; 0 where it has none.
double sigma_at(const Boundary& boundary, double x) {
  const auto& points = boundary.points;
  const auto after = std::lower_bound(points.begin(), points.end(), x,
                                      [](const BoundaryPoint& point, double at) { return point.x < at; });
  if (after == points.end()) return points.empty() ? 0 : points.back().sigma;
  if (after == points.begin()) return after->sigma;
  const BoundaryPoint& before = *(after - 1);
  return std::lerp(before.sigma, after->sigma, (x - before.x) / (after->x - before.x));
}

}  // namespace

std::vector<RoleDeviation> compare(const EstimatedRoles& estimated, const TrueRoles& truth) {
  std::vector<RoleDeviation> result;
  for (std::size_t role = 0; role < kRoleCount; ++role) {
    for (std::size_t i = 0; i < kDistanceCount; ++i) {
      const double x = distance_at(i);
      if (!truth[role].y(x)) continue;
      RoleDeviation one{static_cast<LaneRole>(role), i, std::nullopt, 0};
      if (const Boundary* boundary = estimated[role]; boundary && reaches(*boundary, x)) {
        one.deviation = truth[role].deviation({x, boundary->clothoid.y(x)});
        one.sigma = sigma_at(*boundary, x);
      }
      result.push_back(one);
    }
  }
  return result;
}

}  // namespace lanefuse
