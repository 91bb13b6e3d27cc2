// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "simulation/guard_rails.hpp"
#include "simulation/preset.hpp"
#include "simulation/scene.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse::testing {

/// A car of 4.5 x 1.8 m, known by the middle of its rear.
inline SceneVehicle car(std::int64_t id, const Pose2& world_from_car, double speed, double yaw_rate = 0) {
  SceneVehicle car;
  car.id = id;
  car.world_from_vehicle = world_from_car;
  car.speed = speed;
  car.yaw_rate = yaw_rate;
  car.front = 4.5;
  car.width = 1.8;
  return car;
}

/// An ego car and others where there is no road.
inline Scene open_country(const SceneVehicle& ego, const std::vector<SceneVehicle>& others) {
  Scene scene;
  scene.time = from_nanoseconds(1'000'000'000);
  scene.ego = ego;
  scene.vehicles = others;
  return scene;
}

/// Radars and an object camera without errors, that miss nothing and invent nothing.
inline SensorPreset exact_detections() {
  SensorPreset preset = nominal_preset();
  for (RadarPreset* radar : {&preset.long_range_radar, &preset.short_range_radar}) {
    radar->sigma_range = radar->sigma_azimuth = radar->sigma_range_rate = radar->misalignment = 0;
    radar->detection = 1;
    radar->clutter = 0;
  }
  preset.ghosts.guard_rail_mirrors = {0, 0};
  CameraBoxesPreset& boxes = preset.camera_boxes;
  boxes.sigma_edge_px = boxes.sigma_base_px = boxes.false_boxes = 0;
  boxes.detection_near = boxes.detection_at_90_m = 1;
  preset.camera_pose.residual_pitch = preset.camera_pose.yaw_bias = 0;
  return preset;
}

inline std::shared_ptr<const GuardRails> road_rails() { return std::make_shared<RoadRails>(); }

/// What the sensor says of the scene.
template <typename Message>
Message look(SensorModel& sensor, const Scene& scene) {
  std::vector<Measurement> measurements;
  sensor.observe(scene, measurements);
  return std::move(std::get<Message>(measurements.at(0)));
}

}  // namespace lanefuse::testing
