// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "simulation/preset.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

/// [m/s] in the world, of the point of the vehicle that is at `point` in the world.
Eigen::Vector2d velocity_of(const SceneVehicle& vehicle, const Eigen::Vector2d& point);

/// Something that reflects a radar's waves, in the world.
struct Reflection {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();     ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
};

/// A radar at one moment: where it is, how it moves, and what it measures but for errors.
class RadarView {
 public:
  RadarView(const Scene& scene, const Mounting& mounting, const RadarPreset& radar);

  [[nodiscard]] const Pose2& world_from_radar() const { return world_from_radar_; }
  [[nodiscard]] Eigen::Vector2d in_radar(const Eigen::Vector2d& world_point) const {
    return radar_from_world_ * world_point;
  }

  [[nodiscard]] double range() const { return radar_.range; }  ///< [m]
  /// [rad] to either side that it sees at that range.
  [[nodiscard]] double half_field(double range) const;
  [[nodiscard]] bool sees(const Eigen::Vector2d& world_point) const;

  /// Range, bearing, and the range rate of the reflection's velocity against the radar's own.
  [[nodiscard]] RadarDetection measure(const Reflection& reflection) const;

 private:
  RadarPreset radar_;
  Pose2 world_from_radar_;
  Pose2 radar_from_world_;
  Eigen::Vector2d velocity_;  ///< [m/s] in the world
};

}  // namespace lanefuse
