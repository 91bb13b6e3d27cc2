// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// How pixels of one image fall on the road, as a function of pitch and vertical curvature: what
/// GroundProjection does, with derivatives by formula.
class RoadSight {
 public:
  RoadSight(const CameraModel& camera, const CameraPose& pose);

  /// What is fixed about a pixel whatever the pitch: its ray before the camera is pitched, and how that
  /// changes with the column.
  struct Ray {
    Eigen::Vector3d ray;
    Eigen::Vector3d ray_per_column;
  };
  [[nodiscard]] Ray ray(const Eigen::Vector2d& pixel) const;

  /// Where a ray meets the road, and how that changes with the column, the pitch and the vertical curvature.
  struct Landing {
    Eigen::Vector2d place;
    Eigen::Vector2d per_column;
    Eigen::Vector2d per_pitch;
    Eigen::Vector2d per_vertical_curvature;
  };
  [[nodiscard]] std::optional<Landing> landing(const Ray& ray, double pitch, double vertical_curvature) const;

  /// The pixel of a place on the road; it may lie outside of the image.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& place, double pitch,
                                                     double vertical_curvature) const;

 private:
  const CameraModel* camera_;
  CameraPose pose_;
  Eigen::Matrix3d rolled_;  ///< turns the camera's axes by its roll
  double cos_yaw_;
  double sin_yaw_;
};

}  // namespace lanefuse
