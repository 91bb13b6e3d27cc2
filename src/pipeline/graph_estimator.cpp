// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/graph_estimator.hpp"

#include <utility>

namespace lanefuse {

GraphEstimator::GraphEstimator(const FusionConfig& fusion, const LaneModelConfig& lanes)
    : fusion_config_(fusion),
      lanes_config_(lanes),
      fusion_(fusion_config_, std::make_unique<ConjugateGradientSolver>()),
      lanes_(lanes_config_) {}

const LaneEstimate& GraphEstimator::process(const Cycle& cycle) {
  estimate_.time = cycle.time;
  const FusionResult fusion = fusion_.process(cycle, stage_done_);
  estimate_.inputs = fusion.features;
  if (!fusion.has_motion) {
    give_up(StatusReason::no_motion);
    return estimate_;
  }
  estimate_.speed = cycle.motion.back().speed;
  estimate_.yaw_rate = cycle.motion.back().yaw_rate;
  lanes_.process(fusion_.fused(), moved_since_last_cycle(cycle), estimate_);
  if (!fusion.solve.ok() && estimate_.status == EstimateStatus::ok) {
    estimate_.status = EstimateStatus::degraded;
    estimate_.reason = StatusReason::solver_failed;
  }
  lanes_.explain(fusion_.fused(), debug_);
  fusion_.switch_states(debug_.switches);
  debug_.graph = fusion_.size();
  stage_done_(Stage::lane_model);
  return estimate_;
}

Pose2 GraphEstimator::moved_since_last_cycle(const Cycle& cycle) {
  Pose2 now;
  constexpr Duration kReach = std::chrono::milliseconds(100);
  if (!pose_at(cycle.motion, cycle.time, kReach, now)) return {};
  const Pose2 before = last_odometry_from_vehicle_.value_or(now);
  last_odometry_from_vehicle_ = now;
  return before.inverse() * now;
}

void GraphEstimator::give_up(StatusReason reason) {
  estimate_.status = EstimateStatus::invalid;
  estimate_.reason = reason;
  estimate_.speed = 0;
  estimate_.yaw_rate = 0;
  estimate_.boundaries.clear();
  estimate_.lanes.clear();
  debug_ = {};
}

void GraphEstimator::reset() {
  fusion_.reset();
  lanes_.reset();
  last_odometry_from_vehicle_.reset();
  estimate_ = {};
  debug_ = {};
}

}  // namespace lanefuse
