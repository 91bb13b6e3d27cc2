// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/car_following.hpp"
#include "simulation/lateral_motion.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

/// One moving vehicle of the traffic: what its driver wants, and where that has led to.
struct Vehicle {
  explicit Vehicle(const LateralMotion& motion) : lateral(motion) {}

  std::int64_t id = 0;
  bool truck = false;
  double front = 0;         ///< [m] ahead of the reference point, see SceneVehicle
  double rear = 0;          ///< [m]
  double width = 0;         ///< [m]
  double station = 0;       ///< [m]
  double speed = 0;         ///< [m/s]
  double acceleration = 0;  ///< [m/s^2]
  int lane = 0;             ///< where it is, or where it changes to
  int left_behind = 0;      ///< where it changes from; equals `lane` otherwise
  double pace = 0;          ///< [m/s] that this driver wishes to go faster than the lane's usual speed
  int wish = 0;             ///< for the lane to the left (+1) or right (-1), while it waits for a gap
  double wait = 0;          ///< [s] until it wishes for another lane
  CarFollowing driver;
  LateralMotion lateral;

  /// While it changes, a vehicle fills two lanes.
  [[nodiscard]] bool occupies(int some_lane) const { return some_lane == lane || some_lane == left_behind; }
  [[nodiscard]] double head() const { return station + front; }
  [[nodiscard]] double tail() const { return station - rear; }
};

/// Moves the vehicle by one time step on its own acceleration.
void advance(Vehicle& vehicle, const Road& road, double seconds, Random& random);

/// Where it is in the world. It heads where its reference point moves to: nobody slips.
SceneVehicle in_scene(const Vehicle& vehicle, const Road& road);

}  // namespace lanefuse
