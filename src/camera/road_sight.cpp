// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_sight.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace lanefuse {
namespace {

/// Turns about the y axis by `angle`: nose down.
Eigen::Vector3d pitched(const Eigen::Vector3d& v, double cosine, double sine) {
  return {cosine * v.x() + sine * v.z(), v.y(), -sine * v.x() + cosine * v.z()};
}

}  // namespace

RoadSight::RoadSight(const CameraModel& camera, const CameraPose& pose)
    : camera_(&camera),
      pose_(pose),
      rolled_(Eigen::AngleAxisd(pose.mounting.roll, Eigen::Vector3d::UnitX()).toRotationMatrix()),
      cos_yaw_(std::cos(pose.mounting.yaw)),
      sin_yaw_(std::sin(pose.mounting.yaw)) {}

RoadSight::Ray RoadSight::ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d direction = camera_->direction(pixel);
  const Eigen::Vector2d per_column = camera_->jacobian(direction).inverse().col(0);
  return {rolled_ * Eigen::Vector3d(1, -direction.x(), -direction.y()),
          rolled_ * Eigen::Vector3d(0, -per_column.x(), -per_column.y())};
}

std::optional<RoadSight::Landing> RoadSight::landing(const Ray& ray, double pitch,
                                                     double vertical_curvature) const {
  const double cosine = std::cos(pose_.mounting.pitch + pitch);
  const double sine = std::sin(pose_.mounting.pitch + pitch);
  const auto yawed = [this](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(cos_yaw_ * v.x() - sin_yaw_ * v.y(), sin_yaw_ * v.x() + cos_yaw_ * v.y(), v.z());
  };
  const Eigen::Vector3d before_yaw = pitched(ray.ray, cosine, sine);
  const Eigen::Vector3d r = yawed(before_yaw);
  if (!(r.x() > 0)) return {};
  // z + t r_z = k (x + t r_x)^2 / 2, as an equation for the way ahead X; see GroundProjection.
  const Mounting& at = pose_.mounting;
  const double k = vertical_curvature;
  const double fall = r.z() / r.x();
  const double aside = r.y() / r.x();
  const double rest = fall * at.x - at.z;
  const double discriminant = fall * fall - 2 * k * rest;
  if (!(discriminant > 0) || !(fall < std::sqrt(discriminant))) return {};
  const double root = std::sqrt(discriminant);  // = k X - fall
  const double x = -2 * rest / (root - fall);
  const double ahead = x - at.x;
  if (!(ahead > 0) || !std::isfinite(x)) return {};
  const auto moved = [&](const Eigen::Vector3d& change) {
    const double fall_change = (change.z() - fall * change.x()) / r.x();
    const double aside_change = (change.y() - aside * change.x()) / r.x();
    const double x_change = ahead / root * fall_change;
    return Eigen::Vector2d(x_change, x_change * aside + ahead * aside_change);
  };
  Landing landing;
  landing.place = {x, at.y + ahead * aside};
  landing.per_column = moved(yawed(pitched(ray.ray_per_column, cosine, sine)));
  landing.per_pitch = moved(yawed({before_yaw.z(), 0, -before_yaw.x()}));
  landing.per_vertical_curvature = Eigen::Vector2d(1, aside) * (-x * x / (2 * root));
  return landing;
}

std::optional<Eigen::Vector2d> RoadSight::pixel(const Eigen::Vector2d& place, double pitch,
                                                double vertical_curvature) const {
  const Mounting& at = pose_.mounting;
  const double x = place.x() - at.x;
  const double y = place.y() - at.y;
  const double z = vertical_curvature * place.x() * place.x() / 2 - at.z;
  const Eigen::Vector3d before_yaw(cos_yaw_ * x + sin_yaw_ * y, -sin_yaw_ * x + cos_yaw_ * y, z);
  const Eigen::Vector3d seen =
      rolled_.transpose() * pitched(before_yaw, std::cos(at.pitch + pitch), -std::sin(at.pitch + pitch));
  constexpr double kNearest = 0.5;  // [m]
  if (!(seen.x() > kNearest)) return {};
  return camera_->pixel({-seen.y() / seen.x(), -seen.z() / seen.x()});
}

}  // namespace lanefuse
