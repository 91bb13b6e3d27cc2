// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/camera_model.hpp"

#include <cmath>

#include <Eigen/LU>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kLargestRadiusSquared = 9;  ///< 72 deg off the axis: beyond, a pinhole is the wrong model

bool is_sound(const CameraIntrinsics& camera) {
  bool finite = std::isfinite(camera.cx) && std::isfinite(camera.cy);
  for (const double k : camera.distortion) finite = finite && std::isfinite(k);
  return finite && camera.width > 0 && camera.height > 0 && camera.fx > 0 && camera.fy > 0 &&
         std::isfinite(camera.fx) && std::isfinite(camera.fy);
}

/// The squared radius up to which a larger angle is imaged further out: r (1 + k1 r^2 + k2 r^4 + k3 r^6)
/// grows.
double monotonic_radius_squared(const CameraIntrinsics& camera) {
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  constexpr int kSteps = 900;
  for (int i = 1; i <= kSteps; ++i) {
    const double s = kLargestRadiusSquared * i / kSteps;
    const double slope = 1 + s * (3 * k1 + s * (5 * k2 + s * 7 * k3));
    if (slope <= 0) return kLargestRadiusSquared * (i - 1) / kSteps;
  }
  return kLargestRadiusSquared;
}

}  // namespace

CameraModel::CameraModel(const CameraIntrinsics& intrinsics)
    : intrinsics_(intrinsics), largest_radius_squared_(monotonic_radius_squared(intrinsics)) {
  if (!is_sound(intrinsics)) {
    throw configuration_error("camera", "its size or focal length is not positive, or a number not finite");
  }
}

Eigen::Vector2d CameraModel::distorted(const Eigen::Vector2d& direction) const {
  const auto& [k1, k2, p1, p2, k3] = intrinsics_.distortion;
  const double a = direction.x();
  const double b = direction.y();
  const double s = direction.squaredNorm();
  const double radial = 1 + s * (k1 + s * (k2 + s * k3));
  return {a * radial + 2 * p1 * a * b + p2 * (s + 2 * a * a),
          b * radial + p1 * (s + 2 * b * b) + 2 * p2 * a * b};
}

std::optional<Eigen::Vector2d> CameraModel::pixel(const Eigen::Vector2d& direction) const {
  if (!(direction.squaredNorm() <= largest_radius_squared_)) return {};
  const Eigen::Vector2d d = distorted(direction);
  return Eigen::Vector2d(intrinsics_.cx + intrinsics_.fx * d.x(), intrinsics_.cy + intrinsics_.fy * d.y());
}

Eigen::Matrix2d CameraModel::jacobian(const Eigen::Vector2d& direction) const {
  const auto& [k1, k2, p1, p2, k3] = intrinsics_.distortion;
  const double a = direction.x();
  const double b = direction.y();
  const double s = direction.squaredNorm();
  const double radial = 1 + s * (k1 + s * (k2 + s * k3));
  const double slope = k1 + s * (2 * k2 + s * 3 * k3);  // d radial / d s
  Eigen::Matrix2d j;
  j(0, 0) = radial + 2 * a * a * slope + 2 * p1 * b + 6 * p2 * a;
  j(0, 1) = 2 * a * b * slope + 2 * p1 * a + 2 * p2 * b;
  j(1, 0) = 2 * a * b * slope + 2 * p1 * a + 2 * p2 * b;
  j(1, 1) = radial + 2 * b * b * slope + 6 * p1 * b + 2 * p2 * a;
  j.row(0) *= intrinsics_.fx;
  j.row(1) *= intrinsics_.fy;
  return j;
}

Eigen::Vector2d CameraModel::direction(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d pinhole((pixel.x() - intrinsics_.cx) / intrinsics_.fx,
                                (pixel.y() - intrinsics_.cy) / intrinsics_.fy);
  Eigen::Vector2d direction = pinhole;
  constexpr int kIterations = 20;
  for (int i = 0; i < kIterations; ++i) {
    const Eigen::Vector2d error = distorted(direction) - pinhole;
    if (error.squaredNorm() < 1e-18) break;
    Eigen::Matrix2d j = jacobian(direction);
    j.row(0) /= intrinsics_.fx;
    j.row(1) /= intrinsics_.fy;
    const double determinant = j.determinant();
    if (!(std::abs(determinant) > 1e-6)) break;
    direction -= j.inverse() * error;
  }
  return direction;
}

}  // namespace lanefuse
