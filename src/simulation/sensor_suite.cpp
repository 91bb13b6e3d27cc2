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

constexpr double kTicksHz = 1 / to_seconds(kTick);

void check_rate(double hz, const std::string& what) {
  if (hz > 0 && hz <= kTicksHz * (1 + 1e-6)) return;
  throw configuration_error(
      "preset", fmt::format("{} at {} Hz: rates must be above zero and at most {} Hz", what, hz, kTicksHz));
}

/// How many periods are over when the tick begins; what is missing of one by rounding is not missing.
std::int64_t periods_until(std::int64_t tick, double hz) {
  return static_cast<std::int64_t>(std::floor(static_cast<double>(tick) * hz / kTicksHz + 1e-6));
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

SensorSuite::SensorSuite(double truth_hz) : truth_hz_(truth_hz) { check_rate(truth_hz, "fusion"); }

void SensorSuite::add(std::unique_ptr<SensorModel> sensor) {
  check_rate(sensor->hz(), sensor->description().name);
  sensors_.push_back(std::move(sensor));
}

Rig SensorSuite::rig() const {
  Rig rig;
  for (const auto& sensor : sensors_) rig.sensors.push_back(sensor->description());
  return rig;
}

bool SensorSuite::is_due(double hz) const {
  return ticks_ == 0 || periods_until(ticks_, hz) > periods_until(ticks_ - 1, hz);
}

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
