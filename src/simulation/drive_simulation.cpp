// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/drive_simulation.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/camera_image_model.hpp"
#include "simulation/detection_sensors.hpp"
#include "simulation/gnss_ins_model.hpp"
#include "simulation/high_resolution_camera_model.hpp"
#include "simulation/object_list_model.hpp"
#include "simulation/odometry_model.hpp"
#include "simulation/sensor_noise.hpp"
#include "simulation/serial_camera_model.hpp"
#include "simulation/sumo_traffic.hpp"
#include "simulation/traffic_lanes.hpp"

namespace lanefuse {
namespace {

void check_lane(int lane, const DriveRoad& there) {
  const TrafficLanes lanes(there.road);
  if (lane >= 0 && lane < lanes.count() && lanes.is_through(lane, there.start)) return;
  throw configuration_error("simulation", fmt::format("no lane {} leads on where the drive begins", lane + 1),
                            "the leftmost lane is 1");
}

TrafficConfig traffic_of(const SimulationConfig& config, const SensorPreset& preset, const DriveRoad& there) {
  TrafficConfig traffic = traffic_config(config.scenario, preset);
  traffic.ego_lane = config.ego_lane;
  if (config.ego_lane) check_lane(*config.ego_lane, there);
  if (!config.ego_lane_changes) traffic.ego.lane_change_every = TrafficConfig::kNever;
  return traffic;
}

std::unique_ptr<TrafficModel> make_traffic(const SimulationConfig& config, const SensorPreset& preset,
                                           const DriveRoad& road) {
  const TrafficConfig traffic = traffic_of(config, preset, road);
  if (config.sumo) return sumo_traffic(road.road, traffic, road.start, config.seed);
  return std::make_unique<Traffic>(road.road, traffic, road.start, config.seed);
}

}  // namespace

DriveSimulation::DriveSimulation(const SimulationConfig& config, const SensorPreset& preset)
    : config_(config),
      preset_(with_noise(preset, config.noise)),
      drive_road_(std::make_unique<DriveRoad>(drive_road(config.scenario, config.road, config.km, preset.road,
                                                         config.road_seed.value_or(config.seed)))),
      traffic_(make_traffic(config, preset, *drive_road_)),
      ego_station_(drive_road_->start),
      suite_(preset.fusion_hz) {
  add_sensors();
}

void DriveSimulation::add_sensors() {
  const std::uint64_t seed = config_.seed;
  add_sensor(std::make_unique<OdometryModel>(preset_.odometry, seed));
  add_cameras();
  if (config_.objects && config_.scenario.sensors.objects) add_objects();
  if (config_.gnss_ins && drive_road_->origin) {
    add_sensor(std::make_unique<GnssInsModel>(preset_, *drive_road_->origin, seed));
  }
}

void DriveSimulation::add_objects() {
  if (!config_.detections) return add_sensor(std::make_unique<ObjectListModel>(preset_, config_.seed));
  const auto rails = std::make_shared<RoadRails>();
  for (auto& sensor : detection_sensors(preset_, rails, config_.guard_rail_mirrors, config_.seed)) {
    add_sensor(std::move(sensor));
  }
}

void DriveSimulation::add_cameras() {
  const std::uint64_t seed = config_.seed;
  const bool serial = config_.serial_camera && config_.scenario.sensors.serial_camera;
  const bool high_resolution =
      config_.high_resolution_camera && config_.scenario.sensors.high_resolution_camera;
  if (!config_.images) {
    if (serial) add_sensor(std::make_unique<SerialCameraModel>(preset_, seed));
    if (high_resolution) add_sensor(std::make_unique<HighResolutionCameraModel>(preset_, seed));
    return;
  }
  const auto body = std::make_shared<BodyMotion>(seed);
  const RenderConfig render{.conditions = *config_.images, .seed = seed};
  const auto add_camera = [&](const CameraImageModel::Setup& setup) {
    add_sensor(std::make_unique<CameraImageModel>(setup, preset_.camera_pose, body, render));
  };
  if (serial) add_camera(serial_camera_setup(preset_));
  if (high_resolution) add_camera(high_resolution_camera_setup(preset_));
}

void DriveSimulation::add_sensor(std::unique_ptr<SensorModel> sensor) {
  std::size_t number = 0;
  for (const Disturbance& disturbance : config_.scenario.disturbances) {
    sensor = disturbed(std::move(sensor), disturbance, drive_road_->start, config_.seed, ++number);
  }
  suite_.add(std::move(sensor));
}

RoadMap DriveSimulation::map() const {
  RoadMap map = road_map(drive_road_->road);
  map.name = info().name;
  map.origin = drive_road_->origin;
  return map;
}

DriveInfo DriveSimulation::info() const {
  std::string name =
      fmt::format("simulated, seed {}, {} km, {}", config_.seed, config_.km, drive_road_->name);
  if (config_.scenario.name != Scenario{}.name) name += fmt::format(", {}", config_.scenario.name);
  if (config_.road_seed) name += fmt::format(", road seed {}", *config_.road_seed);
  if (config_.ego_lane) name += fmt::format(", lane {}", *config_.ego_lane + 1);
  if (config_.noise != 1) name += fmt::format(", noise x {}", config_.noise);
  if (config_.images) name += fmt::format(", images, {}", to_string(*config_.images));
  if (config_.detections) name += detections_in_name(config_.guard_rail_mirrors);
  DriveInfo info{name, preset_.hash, WitnessRule::radar_and_camera};
  if (config_.gnss_ins) info.origin = drive_road_->origin;
  return info;
}

double DriveSimulation::progress() const {
  return std::clamp((ego_station_ - drive_road_->start) / (config_.km * 1000), 0.0, 1.0);
}

bool DriveSimulation::step(std::vector<Measurement>& measurements, std::vector<TrueFrame>& truth) {
  if (over_) {
    measurements.clear();
    truth.clear();
    return false;
  }
  const Scene now = traffic_->scene(suite_.next());
  ego_station_ = now.ego.station;
  over_ = progress() >= 1;
  suite_.look(now, over_, measurements, truth);
  if (!over_) traffic_->advance(to_seconds(kTick));
  return true;
}

}  // namespace lanefuse
