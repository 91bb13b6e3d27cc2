// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/drive_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/high_resolution_camera_model.hpp"
#include "simulation/object_list_model.hpp"
#include "simulation/odometry_model.hpp"
#include "simulation/serial_camera_model.hpp"

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

DriveSimulation::DriveSimulation(const SimulationConfig& config, const SensorPreset& preset)
    : config_(config),
      preset_(preset),
      drive_road_(std::make_unique<DriveRoad>(
          drive_road(config.scenario, config.road, config.km, preset.road, config.seed))),
      traffic_(drive_road_->road, traffic_config(config.scenario, preset), drive_road_->start, config.seed) {
  add_sensors();
  ticks_a_period(preset.fusion_hz, "fusion");
  for (const auto& sensor : sensors_) ticks_a_period(sensor->hz(), sensor->description().name.c_str());
}

void DriveSimulation::add_sensors() {
  const std::uint64_t seed = config_.seed;
  const Scenario::SensorsPart& there = config_.scenario.sensors;
  add_sensor(std::make_unique<OdometryModel>(preset_.odometry, seed));
  if (config_.serial_camera && there.serial_camera) {
    add_sensor(std::make_unique<SerialCameraModel>(preset_, seed));
  }
  if (config_.high_resolution_camera && there.high_resolution_camera) {
    add_sensor(std::make_unique<HighResolutionCameraModel>(preset_, seed));
  }
  if (config_.objects && there.objects) add_sensor(std::make_unique<ObjectListModel>(preset_, seed));
}

void DriveSimulation::add_sensor(std::unique_ptr<SensorModel> sensor) {
  std::size_t number = 0;
  for (const Disturbance& disturbance : config_.scenario.disturbances) {
    sensor = disturbed(std::move(sensor), disturbance, drive_road_->start, config_.seed, ++number);
  }
  sensors_.push_back(std::move(sensor));
}

RoadMap DriveSimulation::map() const {
  RoadMap map = road_map(drive_road_->road);
  map.name = info().name;
  map.origin = drive_road_->origin;
  return map;
}

Rig DriveSimulation::rig() const {
  Rig rig;
  for (const auto& sensor : sensors_) rig.sensors.push_back(sensor->description());
  return rig;
}

DriveInfo DriveSimulation::info() const {
  std::string name =
      fmt::format("simulated, seed {}, {} km, {}", config_.seed, config_.km, drive_road_->name);
  if (config_.scenario.name != Scenario{}.name) name += fmt::format(", {}", config_.scenario.name);
  return {name, preset_.hash, WitnessRule::radar_and_camera};
}

double DriveSimulation::progress() const {
  return std::clamp((traffic_.ego().station - drive_road_->start) / (config_.km * 1000), 0.0, 1.0);
}

bool DriveSimulation::is_due(double hz) const { return ticks_ % ticks_a_period(hz, "sensor") == 0; }

void DriveSimulation::measure(const Scene& now) {
  std::vector<Measurement> measured;
  for (const auto& sensor : sensors_) {
    if (is_due(sensor->hz())) sensor->observe(now, measured);
  }
  for (Measurement& measurement : measured) {
    const Stamp& stamp = stamp_of(measurement);
    on_their_way_.emplace(std::pair(stamp.received_at, stamp.sensor_id), std::move(measurement));
  }
}

void DriveSimulation::hand_out(Time now, std::vector<Measurement>& measurements) {
  while (!on_their_way_.empty() && on_their_way_.begin()->first.first <= now) {
    measurements.push_back(std::move(on_their_way_.begin()->second));
    on_their_way_.erase(on_their_way_.begin());
  }
}

bool DriveSimulation::step(std::vector<Measurement>& measurements, std::vector<TrueFrame>& truth) {
  measurements.clear();
  truth.clear();
  if (over_) return false;
  const Scene now = traffic_.scene(kSimulationStart + ticks_ * kTick);
  measure(now);
  if (is_due(preset_.fusion_hz)) truth.push_back(true_frame(now));
  over_ = progress() >= 1;
  hand_out(over_ ? Time::max() : now.time, measurements);
  if (!over_) {
    traffic_.advance(to_seconds(kTick));
    ++ticks_;
  }
  return true;
}

}  // namespace lanefuse
