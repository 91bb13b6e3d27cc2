// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/radar_view.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {

Eigen::Vector2d velocity_of(const SceneVehicle& vehicle, const Eigen::Vector2d& point) {
  const Pose2& pose = vehicle.world_from_vehicle;
  const Eigen::Vector2d lever = point - pose.position();
  return vehicle.speed * Eigen::Vector2d(std::cos(pose.heading), std::sin(pose.heading)) +
         vehicle.yaw_rate * Eigen::Vector2d(-lever.y(), lever.x());
}

RadarView::RadarView(const Scene& scene, const Mounting& mounting, const RadarPreset& radar)
    : radar_(radar),
      world_from_radar_(scene.ego.world_from_vehicle * Pose2{mounting.x, mounting.y, mounting.yaw}),
      radar_from_world_(world_from_radar_.inverse()),
      velocity_(velocity_of(scene.ego, world_from_radar_.position())) {}

double RadarView::half_field(double range) const {
  return (range <= radar_.near_range ? std::max(radar_.near_field, radar_.field) : radar_.field) / 2;
}

bool RadarView::sees(const Eigen::Vector2d& world_point) const {
  const Eigen::Vector2d point = in_radar(world_point);
  const double range = point.norm();
  return range <= radar_.range && std::abs(std::atan2(point.y(), point.x())) <= half_field(range);
}

RadarDetection RadarView::measure(const Reflection& reflection) const {
  const Eigen::Vector2d point = in_radar(reflection.point);
  const Eigen::Vector2d away = (reflection.point - world_from_radar_.position()).normalized();
  return {point.norm(), std::atan2(point.y(), point.x()), away.dot(reflection.velocity - velocity_), {}};
}

}  // namespace lanefuse
