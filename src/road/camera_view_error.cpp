// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/camera_view_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double square(double x) { return x * x; }

}  // namespace

SeenPaint corrected(const Eigen::Vector2d& seen, const Pose2& now_from_measured, const RoadState& state) {
  const GaussianState& numbers = state.numbers();
  const double range = seen.x();
  // A camera's row measures its height over the ground there by the distance: pitch adds to it, and where the
  // road rises it is less.
  const double change = range * numbers.mean(kPaintPitch) - state.relative_height(range);
  const double stretch = 1 / std::clamp(1 - change, 0.6, 1.6);
  const double turn = numbers.mean(kPaintYaw) + numbers.mean(kPaintLean);
  const Eigen::Matrix2d turned = rotation(-turn);
  const Eigen::Matrix2d now = rotation(now_from_measured.heading);
  const Eigen::Vector2d point = turned * (stretch * seen);
  SeenPaint paint;
  paint.point = now * point + now_from_measured.position();
  paint.by_pitch = now * point * (stretch * range);
  paint.by_height = -stretch * (now * point);
  paint.by_turn = now * Eigen::Vector2d(point.y(), -point.x());
  return paint;
}

double own_variance(const Feature& feature, const Eigen::Vector2d& normal, const CameraErrorsConfig& config) {
  const Eigen::Vector2d place(feature.x, feature.y);
  const double range = std::max(place.norm(), 0.1);
  const Eigen::Vector2d ray = place / range;
  const double along = square(normal.dot(ray));
  const double shared_along = square(range * range / config.height * config.pitch_deg.sigma * kDegree);
  const double shared_across =
      square(range * kDegree) * (square(config.yaw_deg.sigma) + square(config.lean_deg.sigma));
  const double all = normal.dot(feature.covariance.topLeftCorner<2, 2>() * normal);
  const double pixel = square(range * config.pixel_mrad * 1e-3);
  const double least =
      along * pixel * square(range / config.height) + (1 - along) * (pixel + square(config.paint));
  return std::max(all - along * shared_along - (1 - along) * shared_across, least);
}

}  // namespace lanefuse
