// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "evaluation/consistency.hpp"
#include "evaluation/deviation.hpp"
#include "evaluation/evaluation_result.hpp"
#include "evaluation/lane_roles.hpp"

namespace lanefuse {

/// What one cycle's estimate says at one distance, for one role that has truth there.
struct RoleDeviation {
  LaneRole role = kEgoLeft;
  std::size_t distance_index = 0;
  std::optional<double> deviation;  ///< [m]; nothing where the estimate does not reach
  double sigma = 0;                 ///< [m] stated by the estimate; 0 where it states none
  double protection = 0;            ///< [m] the bound it vouches for; 0 where it vouches for none
};

/// Compares the estimate's roles with the true ones at every distance, to be counted under every condition
/// that the cycle meets. A boundary answers at d if range_begin <= d <= range_end.
std::vector<RoleDeviation> compare(const EstimatedRoles& estimated, const TrueRoles& truth);

/// Deviations by role and distance, gathered in a stream.
class RoleDeviations {
 public:
  void add(const RoleDeviation& one) {
    (is_ego(one.role) ? ego_ : adjacent_).add(one.distance_index, one.deviation);
  }
  [[nodiscard]] LaneStatistics statistics() const { return {ego_.statistics(), adjacent_.statistics()}; }

 private:
  DeviationByDistance ego_;
  DeviationByDistance adjacent_;
};

/// Whether the sigmas fit and the protection levels hold, by role and distance.
class RoleConsistency {
 public:
  void add(const RoleDeviation& one) {
    if (!one.deviation) return;
    ConsistencyByDistance& lane = is_ego(one.role) ? ego_ : adjacent_;
    lane.add(one.distance_index, *one.deviation, one.sigma);
    lane.add_protection(one.distance_index, *one.deviation, one.protection);
  }
  [[nodiscard]] LaneConsistency statistics() const { return {ego_.statistics(), adjacent_.statistics()}; }

 private:
  ConsistencyByDistance ego_;
  ConsistencyByDistance adjacent_;
};

}  // namespace lanefuse
