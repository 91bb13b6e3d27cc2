// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kFreeHand = 15;    ///< [m/s] from here on the motion across has its own pace
constexpr double kForesight = 5;    ///< [s] ahead, for a lane that gets narrower
constexpr double kStanding = 0.01;  ///< [m/s] below this a vehicle heads where it headed before

/// Metres of reference line a second: the way is longer on the outside of a bend, and part of it goes across.
double station_speed(const Vehicle& vehicle, const Road& road) {
  const LateralMotion::State across = vehicle.lateral.state();
  const double along = std::sqrt(std::max(0.0, vehicle.speed * vehicle.speed - across.speed * across.speed));
  return along / (1 - road.reference().curvature(vehicle.station) * across.position);
}

/// Rises to 1 without a kink, so that the heading stays small at any speed.
LateralMotion::Haste haste_of(const Vehicle& vehicle) {
  if (vehicle.speed >= kFreeHand) return {};
  const double share = vehicle.speed / kFreeHand;
  const double acceleration = vehicle.speed > 0 ? vehicle.acceleration : 0;
  return {share * (2 - share), 2 * (1 - share) * acceleration / kFreeHand};
}

void follow_lanes(Vehicle& vehicle, const TrafficLanes& lanes) {
  const double speed = station_speed(vehicle, lanes.road());
  const auto centre = [&](int lane) {
    return lanes.centre(lane, {vehicle.station, speed, vehicle.speed > 0 ? vehicle.acceleration : 0});
  };
  vehicle.lateral.follow(centre(vehicle.left_behind), centre(vehicle.lane));
  vehicle.lateral.keep_within(
      lanes.room(vehicle.lane, vehicle.station, kForesight * vehicle.speed, vehicle.width));
}

/// Of the angle at which it crosses the road.
double crossing_sine(const Vehicle& vehicle) {
  return std::clamp(vehicle.lateral.state().speed / vehicle.speed, -0.5, 0.5);
}

}  // namespace

void advance(Vehicle& vehicle, const TrafficLanes& lanes, double seconds, Random& random) {
  const double before = station_speed(vehicle, lanes.road());
  vehicle.speed = std::max(0.0, vehicle.speed + seconds * vehicle.acceleration);
  vehicle.lateral.advance(seconds, haste_of(vehicle), random);
  vehicle.station += seconds * (before + station_speed(vehicle, lanes.road())) / 2;
  if (!vehicle.lateral.changing()) vehicle.left_behind = vehicle.lane;
  follow_lanes(vehicle, lanes);
  if (vehicle.speed > kStanding) vehicle.crossing = crossing_sine(vehicle);
}

SceneVehicle in_scene(const Vehicle& vehicle, const Road& road) {
  const LateralMotion::State across = vehicle.lateral.state();
  const bool stands = vehicle.speed <= kStanding;
  const double sine = stands ? vehicle.crossing : crossing_sine(vehicle);
  const double cosine = std::sqrt(1 - sine * sine);
  const double turning =
      stands ? 0 : (across.acceleration - sine * vehicle.acceleration) / (vehicle.speed * cosine);
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
