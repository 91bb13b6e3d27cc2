// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/random.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {

/// How a camera over the origin, looking ahead, sees places on the ground: through a pinhole, and in the
/// belief that the road is flat and the camera mounted as its calibration says. The preset's camera pose errs
/// in pitch (what is left of the body's motion) and yaw (calibration); both wander. Small angles.
class GroundView {
 public:
  /// A row's and a column's error, as angles [rad].
  struct PixelError {
    double row = 0;
    double column = 0;
  };

  GroundView(const CameraPosePreset& preset, Random& random);
  void advance(double seconds, Random& random);

  /// Where in the vehicle frame the camera believes the ground point to be; nothing above the horizon.
  /// `height` [m] of the road there over the plane that touches it under the car.
  [[nodiscard]] std::optional<Eigen::Vector2d> see(const Eigen::Vector2d& point, double height,
                                                   const PixelError& error) const;

  /// Distance on the ground [m] that one image row covers, at the distance `x`.
  [[nodiscard]] double row_footprint(double x, double pixel) const { return x * x * pixel / preset_.height; }

 private:
  CameraPosePreset preset_;
  Wander pitch_;
  Wander yaw_;
};

}  // namespace lanefuse
