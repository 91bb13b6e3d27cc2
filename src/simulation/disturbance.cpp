// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/disturbance.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "simulation/late_messages.hpp"
#include "simulation/poor_visibility.hpp"
#include "simulation/sensor_gaps.hpp"

namespace lanefuse {
namespace {

bool is_camera(SensorKind kind) {
  return kind == SensorKind::serial_camera || kind == SensorKind::high_resolution_camera ||
         kind == SensorKind::object_camera;
}

/// Radars and the object camera stand in for the object list: what is said of it holds for them.
SensorKind named_as(SensorKind kind) {
  const bool stands_in = kind == SensorKind::long_range_radar || kind == SensorKind::short_range_radar ||
                         kind == SensorKind::object_camera;
  return stands_in ? SensorKind::object_fusion : kind;
}

bool befalls(const Disturbance& disturbance, SensorKind kind) {
  if (!disturbance.sensors.empty()) {
    return std::ranges::find(disturbance.sensors, kind) != disturbance.sensors.end() ||
           std::ranges::find(disturbance.sensors, named_as(kind)) != disturbance.sensors.end();
  }
  const bool of_sight =
      disturbance.kind == Disturbance::Kind::blackout || disturbance.kind == Disturbance::Kind::short_range;
  return of_sight ? is_camera(kind) : kind != SensorKind::odometry;
}

LateMessages::Delays delays_of(const Disturbance& disturbance) {
  switch (disturbance.kind) {
    case Disturbance::Kind::stale:
      return {disturbance.share, disturbance.delay / 2, disturbance.delay};
    case Disturbance::Kind::shuffled:
      return {disturbance.share, 0, disturbance.delay};
    default:
      return {0, 0, 0, disturbance.delay};
  }
}

}  // namespace

bool recurs_at(double at, double first, double every, double length) {
  const double since = at - first;
  if (since < 0) return false;
  return every > 0 ? std::fmod(since, every) < length : since < length;
}

std::unique_ptr<SensorModel> disturbed(std::unique_ptr<SensorModel> sensor, const Disturbance& disturbance,
                                       double start, std::uint64_t seed, std::size_t number) {
  const SensorDescription description = sensor->description();
  if (!befalls(disturbance, description.kind)) return sensor;
  switch (disturbance.kind) {
    case Disturbance::Kind::gaps:
      return std::make_unique<SensorGaps>(std::move(sensor), disturbance);
    case Disturbance::Kind::blackout:
    case Disturbance::Kind::short_range:
      return std::make_unique<PoorVisibility>(std::move(sensor), disturbance, start);
    case Disturbance::Kind::latency:
    case Disturbance::Kind::stale:
    case Disturbance::Kind::shuffled:
      break;
  }
  const Random random(seed, fmt::format("disturbance {} of {}", number, description.name));
  return std::make_unique<LateMessages>(std::move(sensor), delays_of(disturbance), random);
}

}  // namespace lanefuse
