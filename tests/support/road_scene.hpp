// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/lane_estimate.hpp"
#include "core/pose2.hpp"
#include "sensors/truth.hpp"

/// A road whose boundaries are parallel copies of one clothoid, seen from one pose, and the estimate that
/// sees all of it exactly: what evaluation and drawing are tested on.
namespace lanefuse::testing {

inline constexpr double kLaneWidth = 3.6;

struct RoadScene {
  Clothoid course{kLaneWidth / 2, 0.01, 4e-4, -1e-6};  ///< the ego lane's left boundary in the vehicle frame
  Pose2 world_from_vehicle{250, -80, 0.7};
  int lanes_left = 1;   ///< of the ego lane
  int lanes_right = 1;  ///< of the ego lane

  [[nodiscard]] int boundary_count() const { return lanes_left + lanes_right + 2; }
  [[nodiscard]] Clothoid boundary(int index) const {
    Clothoid result = course;
    result.lateral_offset += kLaneWidth * (lanes_left - index);
    return result;
  }
};

/// Links lanes 1, 2 ... from left to right between boundaries 101, 102 ...
template <typename AnyLane>
std::vector<AnyLane> linked_lanes(int count) {
  std::vector<AnyLane> lanes;
  for (int i = 1; i <= count; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    AnyLane lane{id, 100 + id, 101 + id, {}, {}};
    if (i > 1) lane.left_lane = id - 1;
    if (i < count) lane.right_lane = id + 1;
    lanes.push_back(lane);
  }
  return lanes;
}

inline TrueRoad true_road(const RoadScene& scene, double from = -60, double to = 220) {
  TrueRoad road;
  for (int i = 0; i < scene.boundary_count(); ++i) {
    TrueBoundary boundary;
    boundary.id = static_cast<std::uint64_t>(101 + i);
    for (double x = from; x <= to; x += 1) {
      boundary.points.push_back(scene.world_from_vehicle * Eigen::Vector2d(x, scene.boundary(i).y(x)));
    }
    road.boundaries.push_back(boundary);
  }
  road.lanes = linked_lanes<TrueLane>(scene.boundary_count() - 1);
  return road;
}

inline TrueFrame true_frame(const RoadScene& scene) {
  TrueFrame frame;
  frame.world_from_vehicle = scene.world_from_vehicle;
  return frame;
}

/// Every boundary as it is, from 0 to `range`, stated with 0.1 m of sigma.
inline LaneEstimate perfect_estimate(const RoadScene& scene, double range = 130) {
  LaneEstimate estimate;
  estimate.status = EstimateStatus::ok;
  estimate.reason = StatusReason::none;
  estimate.speed = 30;
  for (int i = 0; i < scene.boundary_count(); ++i) {
    Boundary boundary;
    boundary.id = static_cast<std::uint64_t>(101 + i);
    boundary.clothoid = scene.boundary(i);
    boundary.covariance(0, 0) = 0.01;
    boundary.range_end = range;
    boundary.confidence = 0.9;
    sample_points(boundary);
    estimate.boundaries.push_back(boundary);
  }
  estimate.lanes = linked_lanes<Lane>(scene.boundary_count() - 1);
  return estimate;
}

/// Changes the boundary's clothoid, and its points with it.
template <typename Change>
void reshape(Boundary& boundary, Change change) {
  change(boundary.clothoid);
  sample_points(boundary);
}

/// Moves all that is estimated to the left.
inline void shift(LaneEstimate& estimate, double left) {
  for (Boundary& boundary : estimate.boundaries) {
    reshape(boundary, [left](Clothoid& clothoid) { clothoid.lateral_offset += left; });
  }
}

}  // namespace lanefuse::testing
