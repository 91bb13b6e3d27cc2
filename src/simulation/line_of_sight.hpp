// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "simulation/scene.hpp"

namespace lanefuse {

/// What the vehicles around hide from a sensor: everything further away in the same direction.
class LineOfSight {
 public:
  /// From the origin of the vehicle frame.
  explicit LineOfSight(const Scene& scene) : LineOfSight(scene, scene.ego.world_from_vehicle) {}
  /// From a sensor that stands elsewhere.
  LineOfSight(const Scene& scene, const Pose2& world_from_sensor);

  /// `point` in the sensor's frame; the vehicle `except` hides nothing (pass its own id for a vehicle).
  [[nodiscard]] bool blocked(const Eigen::Vector2d& point, std::int64_t except = -1) const;
  /// How much of the angle that the vehicle fills nearer ones hide, in [0, 1]; 1 where it is not there.
  [[nodiscard]] double hidden_share(std::int64_t vehicle) const;

 private:
  struct Shadow {
    std::int64_t id;
    double from;   ///< [rad] bearing
    double to;     ///< [rad] bearing
    double range;  ///< [m] to the nearest corner
  };
  std::vector<Shadow> shadows_;
};

}  // namespace lanefuse
