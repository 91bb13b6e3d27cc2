// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/ground_rays.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace lanefuse {

Eigen::Matrix3d vehicle_from_camera(const Mounting& mounting) {
  return (Eigen::AngleAxisd(mounting.yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(mounting.pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(mounting.roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

GroundRays::GroundRays(const CameraModel& camera, const Mounting& mounting, const RoadAhead& road)
    : camera_(&camera),
      mounting_(mounting),
      road_(&road),
      vehicle_from_camera_(vehicle_from_camera(mounting)),
      node_count_((camera.intrinsics().width + kSegment - 1) / kSegment + 1) {
  double slope = -1e9;
  for (double x = 1; x <= kGroundEnd; ++x) {
    slope = std::max(slope, (road.height(mounting.x + x) - mounting.z) / x);
    passing_slope_.push_back(slope);
  }
}

/// Where a ray of that slope meets a straight road with these heights.
double GroundRays::first_guess(double slope) const {
  const auto hit = std::lower_bound(passing_slope_.begin(), passing_slope_.end(), slope);
  const auto metre = static_cast<double>(hit - passing_slope_.begin());
  if (metre < 5) return std::min(5.0, -mounting_.z / std::min(slope, -1e-9));
  return metre + 0.5;
}

Eigen::Vector3d GroundRays::ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d direction = camera_->direction(pixel);
  return vehicle_from_camera_ * Eigen::Vector3d(1, -direction.x(), -direction.y());
}

GroundHit GroundRays::cast(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector3d ray = this->ray(pixel);
  const double slope = ray.z() / ray.x();
  const double aside = ray.y() / ray.x();
  double x = first_guess(slope);
  const bool beyond = x > kGroundEnd;
  if (beyond) x = kGroundEnd;
  RoadPlace place{mounting_.x + x, 0};
  constexpr int kIterations = 5;
  for (int i = 0; i < kIterations; ++i) {
    place = road_->place(mounting_.x + x, mounting_.y + x * aside, place.way);
    if (beyond) break;
    const double over = mounting_.z + x * slope - road_->height(place.way);
    const double rise = road_->height(place.way + 0.5) - road_->height(place.way - 0.5);
    const double step = std::clamp(over / std::min(slope - rise, -1e-4), -0.2 * x, 0.2 * x);
    x -= step;
    if (std::abs(step) < 1e-5 * x) break;
  }
  return {mounting_.x + x, mounting_.y + x * aside, place.way, place.lateral, !beyond && x <= kGroundEnd};
}

void GroundRays::cast(double row, std::vector<GroundHit>& hits) const {
  hits.resize(static_cast<std::size_t>(node_count_));
  for (int node = 0; node < node_count_; ++node) {
    hits[static_cast<std::size_t>(node)] = cast({static_cast<double>(node * kSegment), row});
  }
}

}  // namespace lanefuse
