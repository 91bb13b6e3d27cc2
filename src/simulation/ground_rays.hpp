// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "sensors/rig.hpp"
#include "simulation/road_ahead.hpp"

namespace lanefuse {

/// Where a camera's rays meet the ground.
struct GroundHit {
  double x = 0;         ///< [m] in the vehicle frame
  double y = 0;         ///< [m]
  double way = 0;       ///< [m] along the road
  double lateral = 0;   ///< [m] across it
  bool ground = false;  ///< else the ray passes over the ground's end, and this is the place below it there
};

/// The directions of a camera's rays at the ends of all rows' segments: they are the same in every image.
class SegmentEnds {
 public:
  static constexpr int kSegment = 32;  ///< [px] from one end to the next

  explicit SegmentEnds(const CameraModel& camera);

  /// Ends on a row's edge: in the columns 0, kSegment ... and one beyond the image's right border.
  [[nodiscard]] int count() const { return count_; }
  /// Directions on the upper edge of row `v`; that of the row below the last one is the image's lower edge.
  [[nodiscard]] const Eigen::Vector2d* on_upper_edge(int v) const {
    return &directions_[static_cast<std::size_t>(v) * static_cast<std::size_t>(count_)];
  }

 private:
  int count_;
  std::vector<Eigen::Vector2d> directions_;
};

/// Casts the rays of one image onto the road with its ups and downs; beside the road the ground is as high as
/// the road. Rows are cut into segments of kSegment pixels, at whose ends rays are exact.
class GroundRays {
 public:
  static constexpr int kSegment = SegmentEnds::kSegment;
  static constexpr double kGroundEnd = 400;  ///< [m] ahead; what is beyond belongs to the backdrop

  /// All of them must outlive it.
  GroundRays(const CameraModel& camera, const Mounting& mounting, const RoadAhead& road);

  /// Hits at the ends of segments on the upper edge of row `v`.
  void cast_upper_edge(const SegmentEnds& ends, int v, std::vector<GroundHit>& hits) const;
  [[nodiscard]] GroundHit cast(const Eigen::Vector2d& pixel) const;

  /// Direction of a pixel in the vehicle frame.
  [[nodiscard]] Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;
  [[nodiscard]] const Mounting& mounting() const { return mounting_; }

 private:
  const CameraModel* camera_;
  Mounting mounting_;
  const RoadAhead* road_;
  Eigen::Matrix3d vehicle_from_camera_;
  /// By the metre from the camera on: the steepest slope at which a ray passes over all the road up to there.
  std::vector<double> passing_slope_;

  [[nodiscard]] double first_guess(double slope) const;
  [[nodiscard]] Eigen::Vector3d ray_of(const Eigen::Vector2d& direction) const;
  [[nodiscard]] GroundHit cast_ray(const Eigen::Vector3d& ray) const;
};

Eigen::Matrix3d vehicle_from_camera(const Mounting& mounting);

}  // namespace lanefuse
