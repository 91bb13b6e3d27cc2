// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/odometry_model.hpp"

namespace lanefuse {

OdometryModel::OdometryModel(const OdometryPreset& preset, std::uint64_t seed)
    : preset_(preset),
      random_(seed, "odometry"),
      speed_factor_(1 + random_.normal(preset.speed_scale)),
      yaw_rate_bias_(random_.normal(preset.yaw_rate_bias)) {}

SensorDescription OdometryModel::description() const { return {1, SensorKind::odometry, "odometry", {}}; }

void OdometryModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  VehicleMotion motion;
  motion.stamp = stamp(description(), scene.time, preset_.latency);
  motion.speed = scene.ego.speed * speed_factor_;
  motion.yaw_rate = scene.ego.yaw_rate + yaw_rate_bias_ + random_.normal(preset_.yaw_rate_white);
  measurements.emplace_back(motion);
}

}  // namespace lanefuse
