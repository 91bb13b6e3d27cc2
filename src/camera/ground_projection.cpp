// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/ground_projection.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace lanefuse {
namespace {

Eigen::Matrix3d rotation_of(const Mounting& mounting) {
  return (Eigen::AngleAxisd(mounting.yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(mounting.pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(mounting.roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace

GroundProjection::GroundProjection(const CameraModel& camera, const CameraPose& pose)
    : camera_(&camera), pose_(pose), vehicle_from_camera_(rotation_of(pose.mounting)) {}

std::optional<Eigen::Vector2d> GroundProjection::ground(const Eigen::Vector2d& pixel) const {
  return ground_of_direction(camera_->direction(pixel));
}

std::optional<Eigen::Vector2d> GroundProjection::ground_of_direction(const Eigen::Vector2d& direction) const {
  // The ray from the camera: x ahead, y to the left, z up.
  const Eigen::Vector3d ray = vehicle_from_camera_ * Eigen::Vector3d(1, -direction.x(), -direction.y());
  const Mounting& at = pose_.mounting;
  if (!(ray.x() > 0)) return {};
  // z + t ray_z = k (x + t ray_x)^2 / 2: as an equation for the way x ahead, s = ray_z / ray_x:
  // k X^2 / 2 - s X + (s x - z) = 0, in the form that does not cancel for a small k.
  const double s = ray.z() / ray.x();
  const double k = pose_.vertical_curvature;
  const double rest = s * at.x - at.z;
  const double discriminant = s * s - 2 * k * rest;
  if (!(discriminant >= 0) || !(s < std::sqrt(discriminant))) return {};
  const double x = -2 * rest / (std::sqrt(discriminant) - s);
  if (!(x > at.x) || !std::isfinite(x)) return {};
  const double t = (x - at.x) / ray.x();
  return Eigen::Vector2d(x, at.y + t * ray.y());
}

std::optional<Eigen::Vector2d> GroundProjection::pixel(const Eigen::Vector2d& ground) const {
  return pixel(ground, 0);
}

std::optional<Eigen::Vector2d> GroundProjection::pixel(const Eigen::Vector2d& ground, double height) const {
  const double z = pose_.vertical_curvature * ground.x() * ground.x() / 2 + height;
  const Mounting& at = pose_.mounting;
  const Eigen::Vector3d seen =
      vehicle_from_camera_.transpose() * Eigen::Vector3d(ground.x() - at.x, ground.y() - at.y, z - at.z);
  constexpr double kNearest = 0.1;  // [m]
  if (!(seen.x() > kNearest)) return {};
  return camera_->pixel({-seen.y() / seen.x(), -seen.z() / seen.x()});
}

double GroundProjection::horizon_row(double column) const {
  // The direction (a, b) is level where its ray has no z.
  const Eigen::RowVector3d z = vehicle_from_camera_.row(2);
  const CameraIntrinsics& camera = camera_->intrinsics();
  Eigen::Vector2d direction((column - camera.cx) / camera.fx, 0);
  direction.y() = (z.x() - z.y() * direction.x()) / z.z();
  const std::optional<Eigen::Vector2d> pixel = camera_->pixel(direction);
  return pixel ? pixel->y() : camera.cy + camera.fy * direction.y();
}

std::optional<GroundProjection::Jacobians> GroundProjection::jacobians(const Eigen::Vector2d& pixel) const {
  const auto difference = [](const GroundProjection& more, const GroundProjection& less,
                             const Eigen::Vector2d& there, const Eigen::Vector2d& here,
                             double step) -> std::optional<Eigen::Vector2d> {
    const auto a = more.ground(there);
    const auto b = less.ground(here);
    if (!a || !b) return {};
    return Eigen::Vector2d((*a - *b) / (2 * step));
  };
  Jacobians jacobians;
  constexpr double kPixelStep = 1e-3;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d step = kPixelStep * Eigen::Vector2d::Unit(i);
    const auto column = difference(*this, *this, pixel + step, pixel - step, kPixelStep);
    if (!column) return {};
    jacobians.pixel.col(i) = *column;
  }
  const auto turned = [this](int parameter, double step) {
    CameraPose pose = pose_;
    double* const parameters[] = {&pose.mounting.z, &pose.mounting.roll, &pose.mounting.pitch,
                                  &pose.mounting.yaw, &pose.vertical_curvature};
    *parameters[parameter] += step;
    return GroundProjection(*camera_, pose);
  };
  constexpr double kAngleStep = 1e-6;
  constexpr double kCurvatureStep = 1e-9;
  for (int i = 0; i < 5; ++i) {
    const double step = i == 4 ? kCurvatureStep : kAngleStep;
    const auto column = difference(turned(i, step), turned(i, -step), pixel, pixel, step);
    if (!column) return {};
    if (i == 4) {
      jacobians.vertical_curvature = *column;
    } else {
      jacobians.pose.col(i) = *column;
    }
  }
  return jacobians;
}

}  // namespace lanefuse
