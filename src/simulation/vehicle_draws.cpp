// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle_draws.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/traffic_flow.hpp"

namespace lanefuse {
namespace {

constexpr double kPaceSpread = 2;       ///< [m/s] sigma over the drivers
constexpr double kGapWait = 6;          ///< [s] usual time until there is a gap
constexpr double kTruckWidth = 2.5;     ///< [m]
constexpr double kTruckChangeTime = 6;  ///< [s] of a truck's lane change
constexpr double kLeadPace = 0.85;      ///< of the ego car's wish: so that it follows, and keeps on following

}  // namespace

Vehicle VehicleDraws::place(int lane, double station, double width, double bias) {
  const LateralMotion::Style style{config_.preset.wander_sigma, config_.preset.wander_tau, bias,
                                   lanes_.room(lane, station, 0, width)};
  Vehicle vehicle(LateralMotion(lanes_.centre(lane, {station}).position, style, random_));
  vehicle.width = width;
  vehicle.station = station;
  vehicle.lane = vehicle.left_behind = lane;
  return vehicle;
}

Vehicle VehicleDraws::ego(double station) {
  Vehicle ego = place(config_.ego_lane.value_or(lanes_.middle(station)), station, 1.85, 0);
  ego.id = kEgoId;
  ego.front = 0.9;
  ego.rear = 3.9;
  ego.speed = ego.driver.wished_speed = config_.ego.speed;
  ego.wait = config_.ego.lane_change_every;
  return ego;
}

void VehicleDraws::make_truck(Vehicle& vehicle, double length) {
  vehicle.truck = true;
  vehicle.front = length;
  vehicle.driver.acceleration = 0.7;
  vehicle.lateral.take_time(kTruckChangeTime);
}

Vehicle VehicleDraws::lead_truck(const Vehicle& ego) {
  Vehicle truck = place(ego.lane, ego.head() + *config_.lead_truck_gap, kTruckWidth,
                        random_.normal(config_.preset.driver_bias));
  truck.id = next_id_++;
  make_truck(truck, 13);
  truck.leads_ego = true;
  truck.speed = truck.driver.wished_speed = std::min(kTruckPace, kLeadPace * config_.ego.speed);
  truck.wait = TrafficConfig::kNever;
  return truck;
}

Vehicle VehicleDraws::other(int lane, double station) {
  const int to_the_right = lanes_.count_right_of(lane, station);
  const double trucks = std::min(1.0, config_.preset.trucks * lanes_.through_count(station));
  const bool truck = to_the_right == 0 && random_.chance(trucks);
  const double width = truck ? kTruckWidth : random_.uniform(1.7, 1.95);
  Vehicle vehicle = place(lane, station, width, random_.normal(config_.preset.driver_bias));
  vehicle.id = next_id_++;
  if (truck) {
    make_truck(vehicle, random_.uniform(10, 16.5));
  } else {
    vehicle.front = random_.uniform(3.9, 5.0);
  }
  vehicle.pace = random_.normal(truck ? kPaceSpread / 3 : kPaceSpread);
  vehicle.speed = vehicle.driver.wished_speed =
      vehicle.pace + (truck ? kTruckPace : usual_speed(to_the_right));
  vehicle.wait = wait(truck, station);
  return vehicle;
}

/// Cars change for the trucks too, which never do of their own will; of all wishes one in so many lanes comes
/// to nothing; and to the wish comes the wait for a gap.
double VehicleDraws::wait(bool truck, double station) {
  const double lanes = std::max(1, lanes_.through_count(station));
  const double between = config_.preset.lane_change_every * (1 - config_.preset.trucks) * (lanes - 1) / lanes;
  const double wait = random_.exponential(std::max(between - kGapWait, between / 2));
  if (!truck) return wait;
  return config_.truck_change_every < TrafficConfig::kNever ? random_.exponential(config_.truck_change_every)
                                                            : TrafficConfig::kNever;
}

}  // namespace lanefuse
