// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "simulation/preset.hpp"

namespace lanefuse {

/// The ego car's wish for speed swings between fast and slow, as in a city's rush hour.
struct StopAndGo {
  double fast = 15;    ///< [m/s]
  double slow = 0;     ///< [m/s]; 0 is a stop
  double period = 60;  ///< [s] of one fast and one slow half
};

/// How the traffic of one drive behaves: the preset's, and what a scene wants otherwise.
struct TrafficConfig {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  TrafficPreset preset;                ///< density, trucks, lane changes, wander
  EgoPreset ego;                       ///< `lane_change_every` may be kNever
  std::optional<int> ego_lane;         ///< that the ego car starts in; else the middle one
  double truck_change_every = kNever;  ///< [s] mean, a truck; they keep to the right lane otherwise
  /// [m/s] Mean speed of a jam. Without it, drivers are as fast as the density lets them. A flow below
  /// 15 m/s goes in waves.
  std::optional<double> jam_speed;
  /// [m] at first from the ego car's bumper to a truck ahead in its lane. The truck is slower than the ego
  /// car wishes to be and keeps its lane; no one else gets in between.
  std::optional<double> lead_truck_gap;
  std::optional<StopAndGo> ego_stop_and_go;
  double entering_every = 8;  ///< [s] mean between vehicles on an entry lane; kNever for none
  double leaving = 0.15;      ///< share of the right lane's vehicles that take an exit
};

/// As the preset says, and nothing else.
inline TrafficConfig nominal_traffic(const SensorPreset& preset) {
  TrafficConfig config;
  config.preset = preset.traffic;
  config.ego = preset.ego;
  return config;
}

}  // namespace lanefuse
