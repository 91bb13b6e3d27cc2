// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// Where the rays of one image meet the road, as GroundProjection, with what a small error does to it in
/// closed form: cheap enough for every bar of paint.
class RoadRays {
 public:
  RoadRays(const CameraModel& camera, const CameraPose& pose);

  struct Hit {
    Eigen::Vector2d ground;     ///< [m] in the vehicle frame
    Eigen::Matrix2d per_pixel;  ///< d ground / d (u, v) [m/px]
  };
  /// Nothing at and above the horizon.
  [[nodiscard]] std::optional<Hit> hit(const Eigen::Vector2d& pixel) const;

  /// d ground / d (height, roll, pitch, yaw, vertical curvature) of the pixel that shows `ground`.
  using PerPose = Eigen::Matrix<double, 2, 5>;
  [[nodiscard]] PerPose per_pose(const Eigen::Vector2d& ground) const;

  [[nodiscard]] const CameraPose& pose() const { return pose_; }

 private:
  const CameraModel* camera_;
  CameraPose pose_;
  Eigen::Matrix3d vehicle_from_camera_;
  Eigen::Vector3d roll_axis_;   ///< the camera's x axis in the vehicle frame
  Eigen::Vector3d pitch_axis_;  ///< where the pitch turns, after the yaw
};

}  // namespace lanefuse
