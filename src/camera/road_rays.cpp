// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_rays.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace lanefuse {

RoadRays::RoadRays(const CameraModel& camera, const CameraPose& pose) : camera_(&camera), pose_(pose) {
  const Eigen::AngleAxisd yaw(pose.mounting.yaw, Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd pitch(pose.mounting.pitch, Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd roll(pose.mounting.roll, Eigen::Vector3d::UnitX());
  vehicle_from_camera_ = (yaw * pitch * roll).toRotationMatrix();
  roll_axis_ = vehicle_from_camera_.col(0);
  pitch_axis_ = yaw * Eigen::Vector3d::UnitY();
}

std::optional<RoadRays::Hit> RoadRays::hit(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d direction = camera_->direction(pixel);
  const Eigen::Vector3d ray = vehicle_from_camera_ * Eigen::Vector3d(1, -direction.x(), -direction.y());
  const Mounting& at = pose_.mounting;
  if (!(ray.x() > 0)) return {};
  // As in GroundProjection: k X^2 / 2 - s X + (s x - z) = 0 for the way X ahead, with s the ray's slope.
  const double s = ray.z() / ray.x();
  const double q = ray.y() / ray.x();
  const double k = pose_.vertical_curvature;
  const double rest = s * at.x - at.z;
  const double discriminant = s * s - 2 * k * rest;
  if (!(discriminant > 0)) return {};
  const double root = std::sqrt(discriminant);
  if (!(s < root)) return {};
  const double x = -2 * rest / (root - s);
  const double ahead = x - at.x;
  if (!(ahead > 0) || !std::isfinite(x)) return {};
  Hit hit;
  hit.ground = {x, at.y + ahead * q};
  // d (s, q) / d (a, b), then d ground / d (s, q): (k X - s) dX = (X - x) ds, and k X - s is the root.
  Eigen::Matrix2d slopes;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d d = -vehicle_from_camera_.col(i + 1);
    slopes.col(i) = Eigen::Vector2d(d.z() - s * d.x(), d.y() - q * d.x()) / ray.x();
  }
  Eigen::Matrix2d ground;
  ground << ahead / root, 0, q * ahead / root, ahead;
  hit.per_pixel = ground * slopes * camera_->jacobian(direction).inverse();
  return hit;
}

RoadRays::PerPose RoadRays::per_pose(const Eigen::Vector2d& ground) const {
  const Mounting& at = pose_.mounting;
  const double k = pose_.vertical_curvature;
  const double x = ground.x();
  const double ahead = x - at.x;
  const Eigen::Vector3d ray(1, (ground.y() - at.y) / ahead, (k * x * x / 2 - at.z) / ahead);
  const double q = ray.y();
  const double s = ray.z();
  PerPose per_pose;
  const double per_way = 1 / (k * x - s);
  const auto set = [&](int column, double way, double aside) {
    per_pose.col(column) = Eigen::Vector2d(way, q * way + ahead * aside);
  };
  set(0, per_way, 0);
  const Eigen::Vector3d axes[] = {roll_axis_, pitch_axis_, Eigen::Vector3d::UnitZ()};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d d = axes[i].cross(ray);
    set(1 + i, ahead * (d.z() - s * d.x()) * per_way, d.y() - q * d.x());
  }
  set(4, -x * x / 2 * per_way, 0);
  return per_pose;
}

}  // namespace lanefuse
