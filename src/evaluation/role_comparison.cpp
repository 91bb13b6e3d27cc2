// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/role_comparison.hpp"

namespace lanefuse {
namespace {

bool reaches(const Boundary& boundary, double x) {
  return boundary.range_begin <= x && x <= boundary.range_end;
}

}  // namespace

std::vector<RoleDeviation> compare(const EstimatedRoles& estimated, const TrueRoles& truth) {
  std::vector<RoleDeviation> result;
  for (std::size_t role = 0; role < kRoleCount; ++role) {
    for (std::size_t i = 0; i < kDistanceCount; ++i) {
      const double x = distance_at(i);
      if (!truth[role].y(x)) continue;
      RoleDeviation one{static_cast<LaneRole>(role), i, std::nullopt, 0, 0};
      if (const Boundary* boundary = estimated[role]; boundary && reaches(*boundary, x)) {
        one.deviation = truth[role].deviation({x, lateral_at(*boundary, x)});
        one.sigma = sigma_at(*boundary, x);
        one.protection = protection_at(*boundary, x);
      }
      result.push_back(one);
    }
  }
  return result;
}

}  // namespace lanefuse
