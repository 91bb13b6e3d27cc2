// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sensor_suite.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

std::int64_t ticks_a_period(double hz, const char* what) {
  const double ticks = 1 / (hz * to_seconds(kTick));
  const double whole = std::round(ticks);
  if (whole < 1 || std::abs(ticks - whole) > 1e-6) {
    throw configuration_error("preset",
                              fmt::format("{} at {} Hz: its period is not a multiple of 20 ms", what, hz));
  }
  return static_cast<std::int64_t>(whole);
}

TrueObject true_object(const SceneVehicle& vehicle) {
  return {vehicle.id, vehicle.world_from_vehicle, vehicle.speed, vehicle.front + vehicle.rear, vehicle.width};
}

TrueFrame true_frame(const Scene& scene) {
  TrueFrame frame{scene.time, scene.ego.world_from_vehicle, scene.ego.speed, scene.ego.yaw_rate, {}};
  std::transform(scene.vehicles.begin(), scene.vehicles.end(), std::back_inserter(frame.objects),
                 true_object);
  return frame;
}

}  // namespace

SensorSuite::SensorSuite(double truth_hz) : truth_hz_(truth_hz) { ticks_a_period(truth_hz, "fusion"); }

void SensorSuite::add(std::unique_ptr<SensorModel> sensor) {
  ticks_a_period(sensor->hz(), sensor->description().name.c_str());
  sensors_.push_back(std::move(sensor));
}

Rig SensorSuite::rig() const {
  Rig rig;
  for (const auto& sensor : sensors_) rig.sensors.push_back(sensor->description());
  return rig;
}

bool SensorSuite::is_due(double hz) const { return ticks_ % ticks_a_period(hz, "sensor") == 0; }

void SensorSuite::measure(const Scene& scene) {
  std::vector<Measurement> measured;
  for (const auto& sensor : sensors_) {
    if (is_due(sensor->hz())) sensor->observe(scene, measured);
  }
  for (Measurement& measurement : measured) {
    const Stamp& stamp = stamp_of(measurement);
    on_their_way_.emplace(std::pair(stamp.received_at, stamp.sensor_id), std::move(measurement));
  }
}

void SensorSuite::hand_out(Time now, std::vector<Measurement>& measurements) {
  while (!on_their_way_.empty() && on_their_way_.begin()->first.first <= now) {
    measurements.push_back(std::move(on_their_way_.begin()->second));
    on_their_way_.erase(on_their_way_.begin());
  }
}

void SensorSuite::look(const Scene& scene, bool is_last, std::vector<Measurement>& measurements,
                       std::vector<TrueFrame>& truth) {
  measurements.clear();
  truth.clear();
  measure(scene);
  if (is_due(truth_hz_)) truth.push_back(true_frame(scene));
  hand_out(is_last ? Time::max() : scene.time, measurements);
  ++ticks_;
}

}  // namespace lanefuse
