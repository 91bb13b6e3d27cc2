// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/serial_camera_baseline.hpp"

#include <algorithm>

namespace lanefuse {

void SerialCameraBaseline::add(const Measurement& measurement) {
  if (implausible(measurement)) return;
  if (const auto* motion = std::get_if<VehicleMotion>(&measurement)) {
    speed_ = motion->speed.value_or(speed_);
    yaw_rate_ = motion->yaw_rate.value_or(yaw_rate_);
  }
  const auto* lane = std::get_if<SerialLane>(&measurement);
  if (!lane || (lane_ && lane->stamp.measured_at < lane_->stamp.measured_at)) return;
  lane_ = *lane;
  for (auto* side : {&lane_->left, &lane_->right}) {
    if (*side && !is_plausible(**side)) side->reset();
  }
}

LaneEstimate SerialCameraBaseline::at(Time time) const {
  LaneEstimate estimate;
  estimate.time = time;
  estimate.speed = speed_;
  estimate.yaw_rate = yaw_rate_;
  if (!lane_ || time - lane_->stamp.measured_at > config_.oldest) return estimate;
  const double age = to_seconds(time - lane_->stamp.measured_at);
  const Pose2 then_from_now = constant_turn(speed_, yaw_rate_, age);
  const double usual = lane_->marking_width.value_or(config_.marking_width);
  const auto outward = [usual](const ClothoidMeasurement& side) {
    return side.marking_width.value_or(usual) / 2;
  };
  if (lane_->left)
    estimate.boundaries.push_back(boundary(*lane_->left, outward(*lane_->left), then_from_now));
  if (lane_->right) {
    estimate.boundaries.push_back(boundary(*lane_->right, -outward(*lane_->right), then_from_now));
  }
  if (estimate.boundaries.size() < 2) return estimate;
  estimate.lanes.push_back({1, 1, 2, {}, {}});
  estimate.status = EstimateStatus::ok;
  estimate.reason = StatusReason::none;
  return estimate;
}

Boundary SerialCameraBaseline::boundary(const ClothoidMeasurement& measured, double outward,
                                        const Pose2& then_from_now) const {
  Boundary result;
  result.id = outward > 0 ? 1 : 2;
  Clothoid clothoid = measured.clothoid;
  clothoid.lateral_offset += outward;
  result.clothoid = transform(clothoid, then_from_now);
  result.covariance = measured.covariance;
  result.range_begin = std::max(0.0, measured.range_begin - then_from_now.x);
  result.range_end = std::max(0.0, measured.range_end - then_from_now.x);
  result.confidence = measured.confidence;
  result.marking = measured.marking;
  return result;
}

LaneEstimate extrapolated(LaneEstimate estimate, double reach) {
  for (Boundary& boundary : estimate.boundaries) {
    boundary.range_begin = 0;
    boundary.range_end = std::max(boundary.range_end, reach);
  }
  return estimate;
}

}  // namespace lanefuse
