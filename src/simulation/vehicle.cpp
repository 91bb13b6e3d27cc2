// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

/// Metres of reference line a second: the way is longer on the outside of a bend, and part of it goes across.
double station_speed(const Vehicle& vehicle, const Road& road) {
  const LateralMotion::State across = vehicle.lateral.state();
  const double along = std::sqrt(std::max(0.0, vehicle.speed * vehicle.speed - across.speed * across.speed));
  return along / (1 - road.reference().curvature(vehicle.station) * across.position);
}

}  // namespace

void advance(Vehicle& vehicle, const Road& road, double seconds, Random& random) {
  const double before = station_speed(vehicle, road);
  vehicle.speed = std::max(0.0, vehicle.speed + seconds * vehicle.acceleration);
  vehicle.lateral.advance(seconds, random);
  vehicle.station += seconds * (before + station_speed(vehicle, road)) / 2;
  if (!vehicle.lateral.changing()) vehicle.left_behind = vehicle.lane;
}

SceneVehicle in_scene(const Vehicle& vehicle, const Road& road) {
  const LateralMotion::State across = vehicle.lateral.state();
  const double speed = std::max(vehicle.speed, 1e-3);
  const double sine = std::clamp(across.speed / speed, -0.5, 0.5);
  const double cosine = std::sqrt(1 - sine * sine);
  const double turning = (across.acceleration - sine * vehicle.acceleration) / (speed * cosine);
  SceneVehicle seen;
  seen.id = vehicle.id;
  seen.station = vehicle.station;
  seen.lateral = across.position;
  seen.lane = vehicle.lane;
  seen.world_from_vehicle = road.pose(vehicle.station, across.position) * Pose2{0, 0, std::asin(sine)};
  seen.speed = vehicle.speed;
  seen.yaw_rate = road.reference().curvature(vehicle.station) * station_speed(vehicle, road) + turning;
  seen.front = vehicle.front;
  seen.rear = vehicle.rear;
  seen.width = vehicle.width;
  return seen;
}

}  // namespace lanefuse
