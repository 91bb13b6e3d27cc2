// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sensors/rig.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// What goes wrong with sensors beyond the preset's noise.
struct Disturbance {
  enum class Kind : std::uint8_t {
    gaps = 0,         ///< now and then a sensor says nothing
    latency = 1,      ///< every message takes at least so long
    stale = 2,        ///< a share of the messages comes much later
    shuffled = 3,     ///< messages overtake each other
    blackout = 4,     ///< cameras see nothing on stretches of the road
    short_range = 5,  ///< cameras do not see far
  };

  Kind kind = Kind::gaps;
  /// That it befalls; empty: all but the odometry, or cameras alone. The object list's kind stands for the
  /// radars and the object camera, too.
  std::vector<SensorKind> sensors;
  double first = 0;       ///< [s] or, for a blackout, [m] from the start of the drive
  double every = 10;      ///< [s] or [m] from one to the next; 0: there is only one
  double length = 0.8;    ///< [s] or [m]
  double share = 0.1;     ///< of the messages
  double delay = 0;       ///< [s] at most
  double visibility = 0;  ///< [m]
};

/// The sensor as the disturbance lets it be. `start` [m] is the station of the drive's start. Random numbers
/// come from a stream of the disturbance's own, which its `number` among the scenario's tells from others of
/// its kind.
std::unique_ptr<SensorModel> disturbed(std::unique_ptr<SensorModel> sensor, const Disturbance& disturbance,
                                       double start, std::uint64_t seed, std::size_t number);

}  // namespace lanefuse
