// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/traffic.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kRightmostPace = 28;  ///< [m/s] usual speed of cars in the right lane
constexpr double kPaceStep = 3;        ///< [m/s] more in each lane further left
constexpr double kTruckPace = 24.5;    ///< [m/s] just below the limiter
constexpr double kPaceSpread = 2;      ///< [m/s] sigma over the drivers
constexpr double kLeastHeadway = 40;   ///< [m] from rear to rear of vehicles that enter
constexpr double kLeastGap = 10;       ///< [m] for a lane change, in front and behind
constexpr double kGapWait = 6;         ///< [s] usual time until there is a gap
constexpr double kPoliteBraking = -3;  ///< [m/s^2] asked of anyone by a lane change

double usual_speed(const Road& road, int lane) {
  return kRightmostPace + kPaceStep * (road.lane_count() - 1 - lane);
}

/// Bodies stay within their lane, so that vehicles side by side never touch.
double room_in_lane(const Road& road, double width) { return (road.lane_width() - width) / 2 - 0.02; }

double gap_between(const Vehicle& behind, const Vehicle& ahead) { return ahead.tail() - behind.head(); }

}  // namespace

Traffic::Traffic(const Road& road, const SensorPreset& preset, double start, std::uint64_t seed,
                 const EgoPlan& plan)
    : road_(road), preset_(preset.traffic), ego_preset_(preset.ego), random_(seed, "traffic") {
  for (int lane = 0; lane < road.lane_count(); ++lane) headways_.push_back({draw_headway(), draw_headway()});
  vehicles_.push_back(make_ego(start, plan));
  fill();
}

double Traffic::draw_headway() {
  if (preset_.vehicles_per_metre_lane <= 0) return INFINITY;
  return kLeastHeadway +
         random_.exponential(std::max(1.0, 1 / preset_.vehicles_per_metre_lane - kLeastHeadway));
}

Vehicle Traffic::make_ego(double start, const EgoPlan& plan) {
  const int lane = plan.lane.value_or(road_.lane_count() / 2);
  const double width = 1.85;
  const LateralMotion::Style style{preset_.wander_sigma, preset_.wander_tau, 0, room_in_lane(road_, width)};
  Vehicle ego(LateralMotion(road_.lane_centre(lane), style, random_));
  ego.id = kEgoId;
  ego.front = 0.9;
  ego.rear = 3.9;
  ego.width = width;
  ego.station = start;
  ego.speed = ego.driver.wished_speed = ego_preset_.speed;
  ego.lane = ego.left_behind = lane;
  ego.wait = plan.lane_changes ? ego_preset_.lane_change_every : INFINITY;
  return ego;
}

Vehicle Traffic::make_vehicle(int lane, double station) {
  const bool rightmost = lane == road_.lane_count() - 1;
  const bool truck = rightmost && random_.chance(std::min(1.0, preset_.trucks * road_.lane_count()));
  const double width = truck ? 2.5 : random_.uniform(1.7, 1.95);
  const LateralMotion::Style style{preset_.wander_sigma, preset_.wander_tau,
                                   random_.normal(preset_.driver_bias), room_in_lane(road_, width)};
  Vehicle vehicle(LateralMotion(road_.lane_centre(lane), style, random_));
  vehicle.id = next_id_++;
  vehicle.truck = truck;
  vehicle.front = truck ? random_.uniform(10, 16.5) : random_.uniform(3.9, 5.0);
  vehicle.width = width;
  vehicle.station = station;
  vehicle.pace = random_.normal(truck ? kPaceSpread / 3 : kPaceSpread);
  vehicle.speed = vehicle.driver.wished_speed =
      vehicle.pace + (truck ? kTruckPace : usual_speed(road_, lane));
  if (truck) vehicle.driver.acceleration = 0.7;
  vehicle.lane = vehicle.left_behind = lane;
  vehicle.wait = draw_wait();
  return vehicle;
}

void Traffic::fill() {
  const double middle = ego().station;
  for (int lane = 0; lane < road_.lane_count(); ++lane) {
    double station = middle - kTrafficReach + draw_headway() / 2;
    for (; station < middle + kTrafficReach; station += draw_headway()) {
      Vehicle vehicle = make_vehicle(lane, station);
      const bool beside_ego = ego().occupies(lane) && std::abs(station - middle) < kLeastHeadway;
      if (!beside_ego) vehicles_.push_back(vehicle);
    }
  }
}

void Traffic::advance(double seconds) {
  for (Vehicle& vehicle : vehicles_) accelerate(vehicle);
  for (Vehicle& vehicle : vehicles_) lanefuse::advance(vehicle, road_, seconds, random_);
  for (Vehicle& vehicle : vehicles_) consider_lane_change(vehicle, seconds);
  forget_far_ones();
  for (int lane = 0; lane < road_.lane_count(); ++lane) enter(lane);
}

/// By the nearest vehicle ahead in any lane that this one fills.
void Traffic::accelerate(Vehicle& vehicle) const {
  vehicle.acceleration = vehicle.driver.free(vehicle.speed);
  for (const Vehicle& other : vehicles_) {
    const bool in_the_way = other.occupies(vehicle.lane) || other.occupies(vehicle.left_behind);
    if (&other == &vehicle || !in_the_way || other.station + other.front <= vehicle.head()) continue;
    const double behind = vehicle.driver.behind(vehicle.speed, gap_between(vehicle, other), other.speed);
    vehicle.acceleration = std::min(vehicle.acceleration, behind);
  }
}

void Traffic::consider_lane_change(Vehicle& vehicle, double seconds) {
  vehicle.wait -= seconds;
  if (vehicle.truck || vehicle.wait > 0 || vehicle.lateral.changing()) return;
  if (vehicle.wish == 0) vehicle.wish = draw_wish(vehicle);
  const int lane = vehicle.lane - vehicle.wish;
  if (!has_lane(lane)) {
    wait_anew(vehicle);
  } else if (is_free_for(vehicle, lane)) {
    vehicle.lane = lane;
    vehicle.lateral.change_to(road_.lane_centre(lane));
    if (vehicle.id != kEgoId) vehicle.driver.wished_speed = usual_speed(road_, lane) + vehicle.pace;
    wait_anew(vehicle);
  }
}

/// To the left (+1) or right (-1). Only the ego car insists on a lane that exists; the others' wishes for one
/// that does not come to nothing, so that the outer lanes lose no more vehicles than they gain.
int Traffic::draw_wish(const Vehicle& vehicle) {
  const int wish = random_.chance(0.5) ? 1 : -1;
  return vehicle.id == kEgoId && !has_lane(vehicle.lane - wish) ? -wish : wish;
}

void Traffic::wait_anew(Vehicle& vehicle) {
  vehicle.wish = 0;
  vehicle.wait = vehicle.id == kEgoId ? vehicle.wait + ego_preset_.lane_change_every : draw_wait();
}

/// Cars change for the trucks too, which never do; of all wishes one in `lane_count` comes to nothing; and to
/// the wish comes the wait for a gap.
double Traffic::draw_wait() {
  const double lanes = road_.lane_count();
  const double between = preset_.lane_change_every * (1 - preset_.trucks) * (lanes - 1) / lanes;
  return random_.exponential(std::max(between - kGapWait, between / 2));
}

bool Traffic::is_free_for(const Vehicle& vehicle, int lane) const {
  return std::none_of(vehicles_.begin(), vehicles_.end(), [&](const Vehicle& other) {
    if (other.id == vehicle.id || !other.occupies(lane)) return false;
    const bool other_leads = other.head() > vehicle.head();
    const Vehicle& leader = other_leads ? other : vehicle;
    const Vehicle& follower = other_leads ? vehicle : other;
    const double gap = gap_between(follower, leader);
    return gap < kLeastGap || follower.driver.behind(follower.speed, gap, leader.speed) < kPoliteBraking;
  });
}

void Traffic::forget_far_ones() {
  const double middle = ego().station;
  std::erase_if(vehicles_, [&](const Vehicle& v) { return std::abs(v.station - middle) > kTrafficReach; });
}

void Traffic::enter(int lane) {
  const double ahead = ego().station + kTrafficReach;
  const double behind = ego().station - kTrafficReach;
  double foremost = behind;
  double rearmost = ahead;
  for (const Vehicle& vehicle : vehicles_) {
    if (!vehicle.occupies(lane)) continue;
    foremost = std::max(foremost, vehicle.station);
    rearmost = std::min(rearmost, vehicle.station);
  }
  if (ahead - foremost > headways_[lane].front) enter_at(lane, ahead, true);
  if (rearmost - behind > headways_[lane].rear) enter_at(lane, behind, false);
}

/// Only the slower ones are met from behind, and only the faster ones catch up.
void Traffic::enter_at(int lane, double station, bool ahead) {
  Vehicle vehicle = make_vehicle(lane, station);
  if (ahead == (vehicle.speed >= ego().speed)) {
    --next_id_;
    return;
  }
  Headways& headways = headways_[lane];
  (ahead ? headways.front : headways.rear) = draw_headway();
  vehicles_.push_back(vehicle);
}

Scene scene_at(Time time, const Road& road, const Traffic& traffic) {
  Scene scene{time, &road, in_scene(traffic.ego(), road), {}};
  for (const Vehicle& vehicle : traffic.vehicles()) {
    if (vehicle.id != kEgoId) scene.vehicles.push_back(in_scene(vehicle, road));
  }
  return scene;
}

}  // namespace lanefuse
