// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/road_estimator.hpp"

#include <algorithm>
#include <cmath>

#include "road/seen_view.hpp"

namespace lanefuse {
namespace {

/// How far beyond its ends the dead reckoning may be stretched to a measurement's stamp.
constexpr Duration kReach = std::chrono::milliseconds(100);
constexpr std::size_t kEnoughPaint = 16;  ///< features of a frame near the car
constexpr int kLostFrames = 8;
constexpr std::size_t kUsualFeatures = 1024;  ///< of a cycle, for which there is room from the start
constexpr double kLongestStep = 60;           ///< [m] or more in one cycle: the path began anew

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

}  // namespace

RoadEstimator::RoadEstimator(const RoadConfig& config)
    : config_(config),
      state_(config),
      paint_(config),
      tracked_lane_(config),
      vehicles_(config),
      births_(config),
      writer_(config) {
  debug_.features.reserve(kUsualFeatures);
}

const LaneEstimate& RoadEstimator::process(const Cycle& cycle) {
  estimate_.time = cycle.time;
  estimate_.inputs = {};
  Pose2 odometry_from_vehicle;
  if (cycle.motion.empty() || !pose_at(cycle.motion, cycle.time, kReach, odometry_from_vehicle) ||
      !is_finite(odometry_from_vehicle)) {
    give_up(StatusReason::no_motion);
    for (const FeatureSet& set : cycle.features) {
      estimate_.inputs.dropped += set.features.size() + set.clothoids.size();
    }
    return estimate_;
  }
  estimate_.speed = cycle.motion.back().speed;
  estimate_.yaw_rate = cycle.motion.back().yaw_rate;
  drive(odometry_from_vehicle, cycle.time);
  debug_.features.clear();
  for (KnownLine& line : state_.lines()) line.paint = line.tracked = line.witnessed = 0;
  stage_done_(Stage::association);
  for (const FeatureSet& set : cycle.features) {
    const FeatureSet& possible = impossible_.sort_out(set);
    estimate_.inputs.rejected += impossible_.count();
    take(possible, cycle, odometry_from_vehicle);
  }
  births_.found_lines(state_);
  lane_births_.found_lanes(usual_width_, state_);
  births_.forget_lines(state_);
  stage_done_(Stage::solve);
  state_.rebuild_axis();
  writer_.write(state_, estimate_);
  judge();
  stage_done_(Stage::lane_model);
  return estimate_;
}

void RoadEstimator::drive(const Pose2& odometry_from_vehicle, Time now) {
  const Pose2 before = last_odometry_from_vehicle_.value_or(odometry_from_vehicle);
  const Pose2 moved = before.inverse() * odometry_from_vehicle;
  const double seconds = last_odometry_from_vehicle_ ? std::max(0.0, to_seconds(now - last_cycle_)) : 0;
  last_odometry_from_vehicle_ = odometry_from_vehicle;
  last_cycle_ = now;
  if (moved.position().norm() > kLongestStep || seconds > 5) {
    forget_road();
    return;
  }
  const double driven = state_.driven();
  const double heading = state_.numbers().mean(kHeading);
  state_.drive(moved, seconds);
  const double aside = (rotation(heading) * moved.position()).y();
  births_.move(aside, state_.driven() - driven);
  lane_births_.move(aside, seconds);
}

void RoadEstimator::take(const FeatureSet& set, const Cycle& cycle, const Pose2& odometry_from_vehicle) {
  Pose2 odometry_from_measured;
  const std::size_t items = set.features.size() + set.clothoids.size();
  if (!pose_at(cycle.motion, set.measured_at, kReach, odometry_from_measured) ||
      !is_finite(odometry_from_measured)) {
    estimate_.inputs.dropped += items;
    return;
  }
  const Pose2 now_from_measured = odometry_from_vehicle.inverse() * odometry_from_measured;
  std::size_t used = 0;
  if (!set.clothoids.empty()) {
    const double station = state_.driven() + now_from_measured.x;
    used += tracked_lane_.take(set, now_from_measured, station - tracked_taken_at_, state_);
    tracked_taken_at_ = station;
    show_tracked_lane(set, now_from_measured, tracked_lane_.given_to(), debug_);
  }
  if (!set.features.empty()) {
    const bool vehicles = set.features.front().track_id != kNoTrack;
    if (vehicles) {
      used += 2 * vehicles_.take(set, now_from_measured, state_);
      lane_births_.gather(vehicles_.strays(), state_);
      show_vehicles(set, now_from_measured, state_.vehicles(), debug_);
      usual_width_ = set.lane_width.value_or(LaneWidth{});
    } else {
      if (state_.lines().empty()) paint_.take_headings(set, now_from_measured, state_);
      const std::size_t given =
          paint_.take(set, now_from_measured, state_.driven() - paint_taken_at_, state_);
      paint_taken_at_ = state_.driven();
      used += given;
      show_paint(set, now_from_measured, paint_.given_to(), debug_);
      births_.gather(paint_.strays(), state_);
      if (!state_.lines().empty() && has_lost_the_road()) forget_road();
    }
  }
  used = std::min(used, items);
  estimate_.inputs.used += used;
  estimate_.inputs.dropped += items - used;
  for (KnownLine& line : state_.lines()) {
    if (line.paint + line.tracked + line.witnessed == 0 || line.seen_at == state_.driven()) continue;
    line.seen_for += std::min(20.0, state_.driven() - line.seen_at);
    line.seen_at = state_.driven();
  }
}

/// Once the lines are where no paint is, no gate lets them come back: better to begin anew than to be wrong.
bool RoadEstimator::has_lost_the_road() {
  const PaintUpdate::NearPaint near = paint_.near();
  const bool lost = near.seen >= kEnoughPaint && 2 * near.used < near.seen;
  lost_frames_ = lost ? lost_frames_ + 1 : std::max(0, lost_frames_ - 1);
  return lost_frames_ > kLostFrames;
}

void RoadEstimator::forget_road() {
  state_.clear();
  births_.clear();
  lane_births_.clear();
  lost_frames_ = 0;
  paint_taken_at_ = 0;
  tracked_taken_at_ = 0;
}

void RoadEstimator::judge() {
  estimate_.status = EstimateStatus::ok;
  estimate_.reason = StatusReason::none;
  if (estimate_.boundaries.empty()) {
    estimate_.status = EstimateStatus::invalid;
    estimate_.reason = StatusReason::warming_up;
  } else if (!ego_lane(estimate_)) {
    estimate_.status = EstimateStatus::degraded;
    estimate_.reason = StatusReason::no_ego_lane;
  }
}

void RoadEstimator::give_up(StatusReason reason) {
  estimate_.status = EstimateStatus::invalid;
  estimate_.reason = reason;
  estimate_.speed = 0;
  estimate_.yaw_rate = 0;
  estimate_.boundaries.clear();
  estimate_.lanes.clear();
  debug_ = {};
}

void RoadEstimator::reset() {
  state_ = RoadState(config_);
  paint_ = PaintUpdate(config_);
  forget_road();
  writer_.clear();
  last_odometry_from_vehicle_.reset();
  last_cycle_ = {};
  usual_width_ = {};
  estimate_ = {};
  debug_ = {};
}

}  // namespace lanefuse
