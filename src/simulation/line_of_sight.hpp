// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "simulation/scene.hpp"

namespace lanefuse {

/// What the vehicles around hide from a sensor at the origin: everything further away in the same direction.
class LineOfSight {
 public:
  explicit LineOfSight(const Scene& scene);

  /// `point` in the vehicle frame; the vehicle `except` hides nothing (pass its own id for a vehicle).
  [[nodiscard]] bool blocked(const Eigen::Vector2d& point, std::int64_t except = -1) const;

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
