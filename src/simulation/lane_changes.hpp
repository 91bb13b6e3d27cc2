// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/right_of_way.hpp"
#include "simulation/traffic_config.hpp"
#include "simulation/vehicle_draws.hpp"

namespace lanefuse {

/// When drivers change lanes: because they like to, because theirs ends, or because they leave the road.
class LaneChanges {
 public:
  LaneChanges(const TrafficLanes& lanes, const TrafficConfig& config, VehicleDraws& draws, Random& random)
      : lanes_(lanes), config_(config), draws_(draws), random_(random) {}

  /// Begins a change if the vehicle, one of `all`, wants one and finds a gap.
  void consider(Vehicle& vehicle, const std::vector<Vehicle>& all, double seconds);

 private:
  const TrafficLanes& lanes_;
  const TrafficConfig& config_;
  VehicleDraws& draws_;
  Random& random_;

  [[nodiscard]] std::optional<int> forced(Vehicle& vehicle);
  [[nodiscard]] std::optional<int> out_of_ending(const Vehicle& vehicle) const;
  [[nodiscard]] std::optional<int> to_exit(Vehicle& vehicle);
  void consider_wish(Vehicle& vehicle, const std::vector<Vehicle>& all);
  int draw_wish(const Vehicle& vehicle);
  void wait_anew(Vehicle& vehicle);
  void begin(Vehicle& vehicle, int lane);
};

}  // namespace lanefuse
