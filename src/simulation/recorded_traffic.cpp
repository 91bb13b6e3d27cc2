// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/recorded_traffic.hpp"

#include <algorithm>
#include <cassert>

namespace lanefuse {
namespace {

double stay(const RecordedVehicle& vehicle) {
  return vehicle.states.back().time_s - vehicle.states.front().time_s;
}

const RecordedVehicle& existing(const std::vector<RecordedVehicle>& vehicles, std::int64_t id) {
  const RecordedVehicle* found = find_vehicle(vehicles, id);
  assert(found);
  return *found;
}

}  // namespace

const RecordedVehicle* find_vehicle(const std::vector<RecordedVehicle>& vehicles, std::int64_t id) {
  const auto found = std::ranges::find(vehicles, id, &RecordedVehicle::id);
  return found == vehicles.end() ? nullptr : &*found;
}

const RecordedVehicle& longest_stay(const std::vector<RecordedVehicle>& vehicles) {
  assert(!vehicles.empty());
  return *std::ranges::max_element(vehicles, {}, stay);
}

/// The origin of its frame is under the front axle.
RecordedTraffic::Recorded RecordedTraffic::make_ego(const RecordedVehicle& vehicle) {
  const double rear = vehicle.length - kFrontOverhang;
  return {kEgoId, kFrontOverhang, rear, vehicle.width,
          RecordedMotion(vehicle, vehicle.length / 2 - kFrontOverhang)};
}

/// Objects are known by the middle of their rear.
RecordedTraffic::Recorded RecordedTraffic::make_other(const RecordedVehicle& vehicle) {
  return {vehicle.id, vehicle.length, 0, vehicle.width, RecordedMotion(vehicle, -vehicle.length / 2)};
}

RecordedTraffic::RecordedTraffic(const std::vector<RecordedVehicle>& vehicles, std::int64_t ego)
    : ego_(make_ego(existing(vehicles, ego))), time_(ego_.motion.begin()) {
  for (const RecordedVehicle& vehicle : vehicles) {
    if (vehicle.id != ego) others_.push_back(make_other(vehicle));
  }
}

double RecordedTraffic::progress() const {
  const double stay = ego_.motion.end() - ego_.motion.begin();
  return stay > 0 ? std::clamp((time_ - ego_.motion.begin()) / stay, 0.0, 1.0) : 1;
}

SceneVehicle RecordedTraffic::now(const Recorded& recorded) const {
  const RecordedMotion::State state = recorded.motion.at(time_);
  SceneVehicle seen;
  seen.id = recorded.id;
  seen.station = state.way;
  seen.world_from_vehicle = state.pose;
  seen.speed = state.speed;
  seen.yaw_rate = state.yaw_rate;
  seen.front = recorded.front;
  seen.rear = recorded.rear;
  seen.width = recorded.width;
  return seen;
}

Scene RecordedTraffic::scene(Time time) const {
  Scene scene;
  scene.time = time;
  scene.ego = now(ego_);
  for (const Recorded& other : others_) {
    if (other.motion.is_there(time_)) scene.vehicles.push_back(now(other));
  }
  return scene;
}

}  // namespace lanefuse
