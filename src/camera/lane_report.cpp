// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_report.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {

ClothoidMeasurement measured_edge(const LaneFilter& filter, Side side, const CameraPose& pose) {
  ClothoidMeasurement edge;
  edge.side = side;
  edge.clothoid = LaneState::edge(filter.state().mean, side);
  // What the pose does not know turns and shifts the whole lane: its yaw the heading, its height and roll the
  // offset. The pitch is the filter's own.
  const double y = edge.clothoid.lateral_offset;
  const double height = std::max(0.1, pose.mounting.z);
  Eigen::Matrix4d by_pose = Eigen::Matrix4d::Zero();  // d (y0, theta0, c0, c1) / d (height, roll, pitch, yaw)
  by_pose(0, 0) = y / height;
  by_pose(0, 1) = height + y * y / height;
  by_pose(1, 3) = 1;
  edge.covariance = filter.edge_covariance(side) + by_pose * pose.covariance * by_pose.transpose();
  return edge;
}

void write_state(const Gaussian<LaneState::kSize>& state, LaneTrack& track) {
  const auto sigma = [&state](int i) { return std::sqrt(state.covariance(i, i)); };
  track.lateral_offset = state.mean[LaneState::kOffset];
  track.width = state.mean[LaneState::kWidth];
  track.width_sigma = sigma(LaneState::kWidth);
  track.heading = state.mean[LaneState::kHeading];
  track.curvature = state.mean[LaneState::kCurvature];
  track.pitch = state.mean[LaneState::kPitch];
  track.pitch_sigma = sigma(LaneState::kPitch);
  track.vertical_curvature = state.mean[LaneState::kVerticalCurvature];
  track.vertical_curvature_sigma = sigma(LaneState::kVerticalCurvature);
}

}  // namespace lanefuse
