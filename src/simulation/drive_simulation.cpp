// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/drive_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/gnss_ins_model.hpp"
#include "simulation/high_resolution_camera_model.hpp"
#include "simulation/object_list_model.hpp"
#include "simulation/odometry_model.hpp"
#include "simulation/serial_camera_model.hpp"

namespace lanefuse {
namespace {

constexpr double kLeadIn = 400;   ///< [m] of road behind the start, for those who follow
constexpr double kLeadOut = 600;  ///< [m] of road beyond the end, for those ahead and for what sensors see

double checked_length(double km) {
  if (!(km > 0 && km <= 1000)) {
    throw configuration_error("simulation", fmt::format("{} km is no length of a drive", km),
                              "choose up to 1000 km");
  }
  return km * 1000;
}

EgoPlan checked(const EgoPlan& plan, const Road& road) {
  if (plan.lane && (*plan.lane < 0 || *plan.lane >= road.lane_count())) {
    throw configuration_error("simulation", fmt::format("the road has no lane {}", *plan.lane + 1),
                              fmt::format("choose from 1, on the left, to {}", road.lane_count()));
  }
  return plan;
}

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
      road_(std::make_unique<Road>(config.road, kLeadIn + checked_length(config.km) + kLeadOut, preset.road,
                                   config.road_seed.value_or(config.seed))),
      traffic_(*road_, preset, kLeadIn, config.seed, checked(config.ego, *road_)) {
  add_sensors();
  ticks_a_period(preset.fusion_hz, "fusion");
  for (const auto& sensor : sensors_) ticks_a_period(sensor->hz(), sensor->description().name.c_str());
}

void DriveSimulation::add_sensors() {
  const std::uint64_t seed = config_.seed;
  sensors_.push_back(std::make_unique<OdometryModel>(preset_.odometry, seed));
  if (config_.serial_camera) sensors_.push_back(std::make_unique<SerialCameraModel>(preset_, seed));
  if (config_.high_resolution_camera)
    sensors_.push_back(std::make_unique<HighResolutionCameraModel>(preset_, seed));
  if (config_.objects) sensors_.push_back(std::make_unique<ObjectListModel>(preset_, seed));
  if (config_.gnss_ins) sensors_.push_back(std::make_unique<GnssInsModel>(preset_.gnss_ins, seed));
}

Rig DriveSimulation::rig() const {
  Rig rig;
  for (const auto& sensor : sensors_) rig.sensors.push_back(sensor->description());
  return rig;
}

DriveInfo DriveSimulation::info() const {
  std::string name =
      fmt::format("simulated, seed {}, {} km, {}", config_.seed, config_.km, to_string(config_.road));
  if (config_.road_seed) name += fmt::format(", road seed {}", *config_.road_seed);
  if (config_.ego.lane) name += fmt::format(", lane {}", *config_.ego.lane + 1);
  DriveInfo info{name, preset_.hash, WitnessRule::radar_and_camera};
  if (config_.gnss_ins) info.origin = kSimulatedOrigin;
  return info;
}

double DriveSimulation::progress() const {
  return std::clamp((traffic_.ego().station - kLeadIn) / (config_.km * 1000), 0.0, 1.0);
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
  const Scene now = scene_at(kSimulationStart + ticks_ * kTick, *road_, traffic_);
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
