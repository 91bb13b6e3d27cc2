// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "sensors/camera_intrinsics.hpp"

namespace lanefuse {

/// Between pixels and directions: a pinhole with Brown-Conrady distortion, as OpenCV writes it.
///
/// A direction is what the pinhole without distortion would see at unit distance: (a, b) = (right, down) over
/// depth. Both ways are pure functions; points are undistorted one by one, images never.
class CameraModel {
 public:
  /// Throws a configuration Error where sizes or focal lengths are not positive or a number is not finite.
  explicit CameraModel(const CameraIntrinsics& intrinsics);

  [[nodiscard]] const CameraIntrinsics& intrinsics() const { return intrinsics_; }

  /// The pixel that shows a direction. Nothing beyond the radius where the distortion's polynomial turns
  /// back: no lens images anything there. The pixel may lie outside of the image.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& direction) const;

  /// The direction that a pixel shows, by Newton's method on pixel(), to 1e-9.
  [[nodiscard]] Eigen::Vector2d direction(const Eigen::Vector2d& pixel) const;

  /// d pixel / d direction at `direction` [px].
  [[nodiscard]] Eigen::Matrix2d jacobian(const Eigen::Vector2d& direction) const;

  [[nodiscard]] bool in_image(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < intrinsics_.width - 0.5 &&
           pixel.y() < intrinsics_.height - 0.5;
  }

 private:
  CameraIntrinsics intrinsics_;
  double largest_radius_squared_;

  [[nodiscard]] Eigen::Vector2d distorted(const Eigen::Vector2d& direction) const;
};

}  // namespace lanefuse
