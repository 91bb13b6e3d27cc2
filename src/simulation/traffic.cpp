// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/traffic.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kClearOfEgo = 40;       ///< [m] at the start, ahead and behind
constexpr double kClearOfDenseEgo = 25;  ///< [m] the same in dense traffic
constexpr double kRampPace = 22;         ///< [m/s] at most at the beginning of an entry lane
constexpr double kOutOfSight = 50;       ///< [m] nobody comes from a ramp nearer to the ego car

}  // namespace

Traffic::Traffic(const Road& road, const TrafficConfig& config, double start, std::uint64_t seed)
    : config_(config),
      lanes_(road),
      flow_(config),
      random_(seed, "traffic"),
      draws_(lanes_, config_, random_),
      changes_(lanes_, config_, draws_, random_) {
  for (int lane = 0; lane < lanes_.count(); ++lane) {
    if (lanes_.is_driving(lane)) {
      const double front = flow_.draw_headway(random_);
      headways_.push_back({front, flow_.draw_headway(random_)});
    } else {
      headways_.push_back({});
    }
  }
  vehicles_.push_back(draws_.ego(start));
  vehicles_.front().speed = std::min(vehicles_.front().speed, limit_at(start));
  if (config_.lead_truck_gap) {
    vehicles_.push_back(draws_.lead_truck(ego()));
    vehicles_.front().speed = vehicles_.back().speed;
  }
  for (int lane = 0; lane < lanes_.count(); ++lane) fill(lane);
}

/// And of the truck that it follows, and of the room between the two.
bool Traffic::keeps_clear_of_ego(int lane, double station) const {
  if (!ego().occupies(lane)) return true;
  const double clear = flow_.dense() ? kClearOfDenseEgo : kClearOfEgo;
  const double front = config_.lead_truck_gap ? vehicles_[1].head() : ego().station;
  return station <= ego().station - clear || station >= front + clear;
}

void Traffic::fill(int lane) {
  if (!lanes_.is_driving(lane)) return;
  const double end = ego().station + kTrafficReach;
  double station = ego().station - kTrafficReach + flow_.draw_headway(random_) / 2;
  for (double least = station; station < end;
       station = std::max(least, station + flow_.draw_headway(random_))) {
    if (!lanes_.is_through(lane, station)) continue;
    Vehicle vehicle = draws_.other(lane, station);
    vehicle.speed = std::min(vehicle.speed, limit_at(station));
    least = vehicle.head() + vehicle.driver.standstill_gap;
    if (keeps_clear_of_ego(lane, station)) vehicles_.push_back(vehicle);
  }
}

void Traffic::advance(double seconds) {
  steer_ego();
  for (Vehicle& vehicle : vehicles_) {
    vehicle.acceleration =
        acceleration_among(vehicle, vehicles_, lanes_, {limit_at(vehicle.station), flow_.mean_gap()});
  }
  for (Vehicle& vehicle : vehicles_) lanefuse::advance(vehicle, lanes_, seconds, random_);
  for (Vehicle& vehicle : vehicles_) changes_.consider(vehicle, vehicles_, seconds);
  time_ += seconds;
  forget();
  for (int lane = 0; lane < lanes_.count(); ++lane) {
    enter(lane);
    enter_from_ramp(lane, seconds);
  }
}

void Traffic::steer_ego() {
  if (!config_.ego_stop_and_go) return;
  const StopAndGo& profile = *config_.ego_stop_and_go;
  const bool fast = std::fmod(time_, profile.period) < profile.period / 2;
  vehicles_.front().driver.wished_speed = fast ? profile.fast : profile.slow;
}

void Traffic::forget() {
  const double middle = ego().station;
  std::erase_if(vehicles_, [&](const Vehicle& v) {
    const bool left_the_road = lanes_.is_exit(v.lane) && v.leaving && v.head() >= lanes_.end(v.lane);
    return left_the_road || std::abs(v.station - middle) > kTrafficReach;
  });
}

void Traffic::enter(int lane) {
  const double ahead = ego().station + kTrafficReach;
  const double behind = ego().station - kTrafficReach;
  const bool from_ahead = lanes_.is_through(lane, ahead);
  const bool from_behind = lanes_.is_through(lane, behind);
  if (!from_ahead && !from_behind) return;
  double foremost = behind;
  double rearmost = ahead;
  for (const Vehicle& vehicle : vehicles_) {
    if (!vehicle.occupies(lane)) continue;
    foremost = std::max(foremost, vehicle.station);
    rearmost = std::min(rearmost, vehicle.station);
  }
  if (from_ahead && ahead - foremost > headways_[lane].front) enter_at(lane, ahead, true);
  if (from_behind && rearmost - behind > headways_[lane].rear) enter_at(lane, behind, false);
}

/// On a free road, only the slower ones are met from behind, and only the faster ones catch up. In dense
/// traffic all are as fast as the flow, and come as soon as there is room.
void Traffic::enter_at(int lane, double station, bool ahead) {
  Vehicle vehicle = draws_.other(lane, station);
  if (flow_.dense()) vehicle.speed = std::min(vehicle.speed, limit_at(station));
  const bool comes = flow_.dense() ? fits(vehicle) : ahead != (vehicle.speed >= ego().speed);
  if (!comes) {
    draws_.take_back();
    return;
  }
  Headways& headways = headways_[lane];
  (ahead ? headways.front : headways.rear) = flow_.draw_headway(random_);
  vehicles_.push_back(vehicle);
}

bool Traffic::fits(const Vehicle& newcomer) const { return is_free_for(newcomer, newcomer.lane, vehicles_); }

void Traffic::enter_from_ramp(int lane, double seconds) {
  if (!lanes_.is_entry(lane)) return;
  const double station = lanes_.begin(lane);
  const double off = std::abs(station - ego().station);
  if (off > kTrafficReach || off < kOutOfSight || !random_.chance(seconds / config_.entering_every)) return;
  Vehicle vehicle = draws_.other(lane, station);
  vehicle.speed = std::min({vehicle.speed, kRampPace, limit_at(station)});
  if (fits(vehicle)) {
    vehicles_.push_back(vehicle);
  } else {
    draws_.take_back();
  }
}

Scene Traffic::scene(Time time) const {
  Scene scene{time, &lanes_.road(), in_scene(ego(), lanes_.road()), {}};
  for (const Vehicle& vehicle : vehicles_) {
    if (vehicle.id != kEgoId) scene.vehicles.push_back(in_scene(vehicle, lanes_.road()));
  }
  return scene;
}

}  // namespace lanefuse
