// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/commonroad_vehicles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/pose2.hpp"

namespace lanefuse {
namespace {

constexpr double kLongestVehicle = 100;  // [m]

// Beyond these no recording goes; what is made of a vehicle's motion grows with their squares.
constexpr double kLongestStay = 1000;   // [s]
constexpr double kLongestWay = 20'000;  // [m]

RecordedKind kind_of(const std::string& type) {
  if (type == "car" || type == "taxi" || type == "priorityVehicle") return RecordedKind::car;
  if (type == "truck") return RecordedKind::truck;
  if (type == "bus") return RecordedKind::bus;
  if (type == "motorcycle") return RecordedKind::motorcycle;
  return RecordedKind::other;
}

double extent(const XmlElement& element) {
  const double value = element.content_number();
  if (value <= 0 || value > kLongestVehicle) throw element.error(fmt::format("{} m is no vehicle's", value));
  return value;
}

void read_shape(const XmlElement& shape, RecordedVehicle& vehicle) {
  if (const auto rectangle = shape.find("rectangle")) {
    vehicle.length = extent(rectangle->child("length"));
    vehicle.width = extent(rectangle->child("width"));
  } else if (const auto circle = shape.find("circle")) {
    vehicle.length = vehicle.width = 2 * extent(circle->child("radius"));
  } else {
    throw shape.error("is neither a rectangle nor a circle");
  }
}

/// The value itself, or the middle of the interval it was given as.
double value_of(const XmlElement& quantity) {
  if (const auto exact = quantity.find("exact")) return exact->content_number();
  return (quantity.child("intervalStart").content_number() + quantity.child("intervalEnd").content_number()) /
         2;
}

RecordedState read_state(const XmlElement& element, double time_step) {
  const XmlElement point = element.child("position").child("point");
  const double heading = value_of(element.child("orientation"));
  const auto velocity = element.find("velocity");
  return {value_of(element.child("time")) * time_step, point.child("x").content_number(),
          point.child("y").content_number(), wrap_angle(heading), velocity ? value_of(*velocity) : 0};
}

double step_between(const RecordedState& from, const RecordedState& to) {
  return std::hypot(to.x - from.x, to.y - from.y);
}

RecordedVehicle read_vehicle(const XmlElement& element, double time_step) {
  RecordedVehicle vehicle;
  vehicle.id = element.integer("id");
  vehicle.kind = kind_of(element.child("type").content());
  read_shape(element.child("shape"), vehicle);
  vehicle.states.push_back(read_state(element.child("initialState"), time_step));
  double way = 0;
  for (const XmlElement& state : element.child("trajectory").children("state")) {
    vehicle.states.push_back(read_state(state, time_step));
    if (vehicle.states.back().time_s <= (vehicle.states.end() - 2)->time_s) {
      throw state.error("is no later than the state before it");
    }
    way += step_between(*(vehicle.states.end() - 2), vehicle.states.back());
    if (vehicle.states.back().time_s - vehicle.states.front().time_s > kLongestStay || way > kLongestWay) {
      throw state.error(
          fmt::format("is more than {} s or {} m from the vehicle's first", kLongestStay, kLongestWay));
    }
  }
  return vehicle;
}

bool is_dynamic(const XmlElement& obstacle) {
  if (obstacle.name() == "dynamicObstacle") return true;
  return obstacle.name() == "obstacle" && obstacle.child("role").content() == "dynamic";
}

}  // namespace

const char* to_string(RecordedKind kind) {
  constexpr std::array kNames = {"car", "truck", "bus", "motorcycle", "other"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::vector<RecordedVehicle> read_commonroad_vehicles(const XmlElement& root, double time_step) {
  std::vector<RecordedVehicle> vehicles;
  std::set<std::int64_t> seen;
  for (const XmlElement& element : root.children()) {
    if (!is_dynamic(element) || !element.find("trajectory")) continue;
    vehicles.push_back(read_vehicle(element, time_step));
    if (!seen.insert(vehicles.back().id).second) throw element.error("has the id of another obstacle");
  }
  return vehicles;
}

}  // namespace lanefuse
