// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sensor_noise.hpp"

#include <initializer_list>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

void scale(double factor, std::initializer_list<double*> sigmas) {
  for (double* sigma : sigmas) *sigma *= factor;
}

void scale_cameras(double factor, SensorPreset& preset) {
  scale(factor, {&preset.camera_pose.residual_pitch, &preset.camera_pose.yaw_bias});
  scale(factor, {&preset.serial_camera.noise_px});
  HighResolutionCameraPreset& camera = preset.high_resolution_camera;
  scale(factor, {&camera.noise_px, &camera.noise, &camera.heading.base, &camera.heading.at_100_m,
                 &camera.shared_sigma_at_100_m});
  scale(factor, {&preset.camera_boxes.sigma_edge_px, &preset.camera_boxes.sigma_base_px});
}

void scale_objects(double factor, SensorPreset& preset) {
  ObjectListPreset& objects = preset.object_list;
  scale(factor, {&objects.sigma_y.base, &objects.sigma_y.at_100_m, &objects.heading.low,
                 &objects.heading.high, &objects.misalignment});
  for (RadarPreset* radar : {&preset.long_range_radar, &preset.short_range_radar}) {
    scale(factor,
          {&radar->sigma_range, &radar->sigma_azimuth, &radar->sigma_range_rate, &radar->misalignment});
  }
}

void scale_motion(double factor, SensorPreset& preset) {
  OdometryPreset& odometry = preset.odometry;
  scale(factor, {&odometry.speed_scale, &odometry.yaw_rate_white, &odometry.yaw_rate_bias});
  scale(factor, {&preset.gnss_ins.position, &preset.gnss_ins.heading});
}

}  // namespace

SensorPreset with_noise(const SensorPreset& preset, double factor) {
  if (!(factor >= kNoiseFactors.low && factor <= kNoiseFactors.high)) {
    throw configuration_error("noise", fmt::format("{} is no factor", factor),
                              fmt::format("from {} to {}", kNoiseFactors.low, kNoiseFactors.high));
  }
  SensorPreset scaled = preset;
  if (factor == 1) return scaled;
  scale_cameras(factor, scaled);
  scale_objects(factor, scaled);
  scale_motion(factor, scaled);
  scaled.noise *= factor;
  scaled.hash = fmt::format("{}, noise x {}", preset.hash, factor);
  return scaled;
}

}  // namespace lanefuse
