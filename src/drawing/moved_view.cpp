// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/moved_view.hpp"

namespace lanefuse {

LaneEstimate moved_by(const LaneEstimate& estimate, double seconds) {
  const Pose2 old_from_new = constant_turn(estimate.speed, estimate.yaw_rate, seconds);
  LaneEstimate moved = estimate;
  moved.time += from_seconds(seconds);
  for (Boundary& boundary : moved.boundaries) {
    boundary.clothoid = transform(boundary.clothoid, old_from_new);
    boundary.range_begin -= old_from_new.x;
    boundary.range_end -= old_from_new.x;
    sample_points(boundary);
  }
  return moved;
}

DebugView moved_by(const DebugView& debug, const Pose2& old_from_new) {
  const Pose2 new_from_old = old_from_new.inverse();
  DebugView moved = debug;
  for (FusedFeature& fused : moved.features) {
    Feature& feature = fused.feature;
    const Pose2 pose = new_from_old * Pose2{feature.x, feature.y, feature.heading};
    feature.x = pose.x;
    feature.y = pose.y;
    feature.heading = pose.heading;
    feature.covariance = rotate_covariance(feature.covariance, new_from_old.heading);
  }
  for (SwitchState& edge : moved.switches) {
    edge.from = new_from_old * edge.from;
    edge.to = new_from_old * edge.to;
  }
  if (moved.base_clothoid) moved.base_clothoid = transform(*moved.base_clothoid, old_from_new);
  return moved;
}

}  // namespace lanefuse
