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

SegmentEnds::SegmentEnds(const CameraModel& camera)
    : count_((camera.intrinsics().width + kSegment - 1) / kSegment + 1) {
  for (int v = 0; v <= camera.intrinsics().height; ++v) {
    for (int i = 0; i < count_; ++i) {
      directions_.push_back(camera.direction({static_cast<double>(i * kSegment), v - 0.5}));
    }
  }
}

GroundRays::GroundRays(const CameraModel& camera, const Mounting& mounting, const RoadAhead& road)
    : camera_(&camera),
      mounting_(mounting),
      road_(&road),
      vehicle_from_camera_(vehicle_from_camera(mounting)) {
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

Eigen::Vector3d GroundRays::ray_of(const Eigen::Vector2d& direction) const {
  return vehicle_from_camera_ * Eigen::Vector3d(1, -direction.x(), -direction.y());
}

Eigen::Vector3d GroundRays::ray(const Eigen::Vector2d& pixel) const {
  return ray_of(camera_->direction(pixel));
}

GroundHit GroundRays::cast(const Eigen::Vector2d& pixel) const { return cast_ray(ray(pixel)); }

GroundHit GroundRays::cast_ray(const Eigen::Vector3d& ray) const {
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

void GroundRays::cast_upper_edge(const SegmentEnds& ends, int v, std::vector<GroundHit>& hits) const {
  const Eigen::Vector2d* const directions = ends.on_upper_edge(v);
  hits.resize(static_cast<std::size_t>(ends.count()));
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = cast_ray(ray_of(directions[i]));
}

}  // namespace lanefuse
