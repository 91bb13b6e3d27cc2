// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/marking_covariance.hpp"

#include <cmath>

namespace lanefuse {
namespace {

constexpr double kArm = 0.5;  ///< [m] to either side, over which a direction's change is taken

/// d (x, y, heading) / d (height, roll, pitch, yaw, vertical curvature).
Eigen::Matrix<double, 3, 5> by_pose(const RoadRays& rays, const RoadBar& bar) {
  const Eigen::Vector2d along(std::cos(bar.heading), std::sin(bar.heading));
  const Eigen::RowVector2d across(-along.y(), along.x());
  const Eigen::Vector2d place(bar.x, bar.y);
  Eigen::Matrix<double, 3, 5> by_pose;
  by_pose.topRows<2>() = rays.per_pose(place);
  const RoadRays::PerPose ahead = rays.per_pose(place + kArm * along);
  const RoadRays::PerPose behind = rays.per_pose(place - kArm * along);
  by_pose.row(2) = across * (ahead - behind) / (2 * kArm);
  return by_pose;
}

}  // namespace

Eigen::Matrix3d marking_covariance(const RoadRays& rays, const RoadBar& bar, const PixelSigma& noise,
                                   double heading_sigma) {
  const CameraPose& pose = rays.pose();
  const Eigen::Matrix<double, 3, 5> j = by_pose(rays, bar);
  Eigen::Matrix3d covariance =
      j.leftCols<4>() * pose.covariance * j.leftCols<4>().transpose() +
      pose.vertical_curvature_sigma * pose.vertical_curvature_sigma * j.col(4) * j.col(4).transpose();
  const Eigen::Vector2d variance(noise.across * noise.across, noise.along * noise.along);
  covariance.topLeftCorner<2, 2>() += bar.per_pixel * variance.asDiagonal() * bar.per_pixel.transpose();
  covariance(2, 2) += heading_sigma * heading_sigma;
  return (covariance + covariance.transpose()) / 2;
}

}  // namespace lanefuse
