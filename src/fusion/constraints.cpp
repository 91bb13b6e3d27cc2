// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/constraints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Eigen::Matrix3d information_from_sigmas(double along, double across, double heading) {
  return Eigen::Vector3d(1 / (along * along), 1 / (across * across), 1 / (heading * heading)).asDiagonal();
}

}  // namespace

Eigen::Matrix3d odometry_information(const OdometryNoise& noise, double distance, double seconds) {
  // A millimetre and a hundredth of a degree keep the matrix finite when the car hardly moves.
  const double along = noise.speed_scale * distance + 1e-3;
  const double across = noise.slip * distance + 1e-3;
  const double heading =
      kDegree * (std::hypot(noise.yaw_rate_white * std::sqrt(seconds), noise.yaw_rate_bias * seconds) + 0.01);
  return information_from_sigmas(along, across, heading);
}

Eigen::Matrix3d measurement_information(const Feature& feature, double sigma_along) {
  const Eigen::Matrix3d own = rotate_covariance(feature.covariance, -feature.heading);
  return information_from_sigmas(std::max(sigma_along, std::sqrt(own(0, 0))), std::sqrt(own(1, 1)),
                                 std::sqrt(own(2, 2)));
}

Pose2 width_target(const LaneWidth& width) { return {0, width.mean, 0}; }

Eigen::Matrix3d width_information(const LaneWidth& width, const FusionConfig& config) {
  const double heading = kDegree * config.width_heading_deg;
  const double variance =
      width.standard_deviation * width.standard_deviation + config.width_sigma * config.width_sigma;
  return Eigen::Vector3d(0, 1 / variance, 1 / (heading * heading)).asDiagonal();
}

Eigen::Matrix3d smoothing_information(const FusionConfig& config) {
  const double heading = kDegree * config.smoothing_heading_deg;
  const double sigma = config.smoothing_sigma;
  return Eigen::Vector3d(0, 1 / (sigma * sigma), 1 / (heading * heading)).asDiagonal();
}

}  // namespace lanefuse
