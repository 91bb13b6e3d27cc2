// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/car_following.hpp"
#include "simulation/traffic_config.hpp"

namespace lanefuse {

/// What a density does to the traffic: how far apart vehicles enter, and how fast anyone can be.
///
/// Where the road is free, drivers have their own wishes. Above some 20 vehicles a kilometre and lane they
/// cannot have them, and in a jam the flow goes in waves that wander backwards through the vehicles.
class TrafficFlow {
 public:
  explicit TrafficFlow(const TrafficConfig& config);

  /// Too many vehicles for each to be placed without a look at the one ahead.
  [[nodiscard]] bool dense() const { return least_headway_ < kFreeHeadway; }
  /// Speed [m/s] that the flow allows here, `time` [s] after the start of the drive.
  [[nodiscard]] double speed_limit(double station, double time) const;
  /// [m] from rear to rear of vehicles that enter one after the other.
  [[nodiscard]] double draw_headway(Random& random) const;
  /// [m] from bumper to bumper in dense traffic; infinite on a free road.
  [[nodiscard]] double mean_gap() const;

 private:
  static constexpr double kFreeHeadway = 40;  ///< [m]

  double density_;        ///< [1/m]
  double least_headway_;  ///< [m]
  double speed_;          ///< [m/s] of the flow; infinite where it is free
  double wave_;           ///< by how much of its speed the flow swings
};

/// Usual speed [m/s] of cars with so many lanes to their right.
double usual_speed(int lanes_to_the_right);

inline constexpr double kTruckPace = 24.5;  ///< [m/s] just below the limiter

}  // namespace lanefuse
