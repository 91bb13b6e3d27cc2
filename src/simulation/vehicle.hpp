// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/car_following.hpp"
#include "simulation/lateral_motion.hpp"
#include "simulation/scene.hpp"
#include "simulation/traffic_lanes.hpp"

namespace lanefuse {

/// One moving vehicle of the traffic: what its driver wants, and where that has led to.
struct Vehicle {
  explicit Vehicle(const LateralMotion& motion) : lateral(motion) {}

  std::int64_t id = 0;
  bool truck = false;
  bool leads_ego = false;         ///< and keeps its lane to do so
  double front = 0;               ///< [m] ahead of the reference point, see SceneVehicle
  double rear = 0;                ///< [m]
  double width = 0;               ///< [m]
  double station = 0;             ///< [m]
  double speed = 0;               ///< [m/s]
  double acceleration = 0;        ///< [m/s^2]
  double crossing = 0;            ///< sine of the angle at which it crosses the road, when it last moved
  int lane = 0;                   ///< where it is, or where it changes to
  int left_behind = 0;            ///< where it changes from; equals `lane` otherwise
  double pace = 0;                ///< [m/s] that this driver wishes to go faster than the lane's usual speed
  int wish = 0;                   ///< for the lane to the left (+1) or right (-1), while it waits for a gap
  double wait = 0;                ///< [s] until it wishes for another lane
  std::optional<int> must_enter;  ///< the lane it has to change to, as its own ends or it takes an exit
  std::optional<int> exit_seen;   ///< the last exit lane that it made up its mind about
  bool leaving = false;           ///< and its decision
  CarFollowing driver;
  LateralMotion lateral;

  /// While it changes, a vehicle fills two lanes.
  [[nodiscard]] bool occupies(int some_lane) const { return some_lane == lane || some_lane == left_behind; }
  [[nodiscard]] double head() const { return station + front; }
  [[nodiscard]] double tail() const { return station - rear; }
};

/// [m] from the bumper behind to the bumper ahead; negative where they are side by side.
inline double gap_between(const Vehicle& behind, const Vehicle& ahead) {
  return ahead.tail() - behind.head();
}

/// Moves the vehicle by one time step on its own acceleration.
void advance(Vehicle& vehicle, const TrafficLanes& lanes, double seconds, Random& random);

/// Where it is in the world. It heads where its reference point moves to: nobody slips.
SceneVehicle in_scene(const Vehicle& vehicle, const Road& road);

}  // namespace lanefuse
