// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// Between pixels and the road: the camera of one image over a road that is straight across and bends up or
/// down ahead, z = vertical_curvature x^2 / 2 in the vehicle frame.
class GroundProjection {
 public:
  GroundProjection(const CameraModel& camera, const CameraPose& pose);

  [[nodiscard]] const CameraPose& pose() const { return pose_; }

  /// Where in the vehicle frame [m] the pixel meets the road ahead; nothing at and above the horizon.
  [[nodiscard]] std::optional<Eigen::Vector2d> ground(const Eigen::Vector2d& pixel) const;
  /// The same for a direction of the camera model, where points have been undistorted already.
  [[nodiscard]] std::optional<Eigen::Vector2d> ground_of_direction(const Eigen::Vector2d& direction) const;

  /// The pixel of a place on the road; nothing behind the camera. It may lie outside of the image.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& ground) const;
  /// The same for a point `height` [m] over the road.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& ground, double height) const;

  /// The row [px] of the horizon of the plane under the car, in the column `column` [px].
  [[nodiscard]] double horizon_row(double column) const;

  /// d ground / d (u, v) [m/px] and d ground / d (height, roll, pitch, yaw) [-, m/rad] where the pixel meets
  /// the road; by central differences of the exact projection.
  struct Jacobians {
    Eigen::Matrix2d pixel;
    Eigen::Matrix<double, 2, 4> pose;
    Eigen::Vector2d vertical_curvature;  ///< d ground / d vertical_curvature [m^2]
  };
  [[nodiscard]] std::optional<Jacobians> jacobians(const Eigen::Vector2d& pixel) const;

 private:
  const CameraModel* camera_;
  CameraPose pose_;
  Eigen::Matrix3d vehicle_from_camera_;
};

}  // namespace lanefuse
