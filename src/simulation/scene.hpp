// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/pose2.hpp"
#include "core/time.hpp"
#include "simulation/road.hpp"

namespace lanefuse {

/// A vehicle as it really is at one moment. Its reference point is the middle of its rear, but for the ego
/// car, where it is the origin of the vehicle frame: at road height under the middle of the front axle.
struct SceneVehicle {
  std::int64_t id = 0;
  double station = 0;  ///< [m] of the reference point, along the road
  double lateral = 0;  ///< [m] across it
  int lane = 0;        ///< that it drives in or, changing, drives into
  Pose2 world_from_vehicle;
  double speed = 0;     ///< [m/s]
  double yaw_rate = 0;  ///< [rad/s]
  double front = 0;     ///< [m] it reaches ahead of its reference point
  double rear = 0;      ///< [m] and behind it
  double width = 0;     ///< [m]
};

/// All that sensors may look at.
struct Scene {
  Time time{};
  const Road* road = nullptr;
  SceneVehicle ego;
  std::vector<SceneVehicle> vehicles;                           ///< the others
  double visibility = std::numeric_limits<double>::infinity();  ///< [m] that cameras see at most
};

}  // namespace lanefuse
