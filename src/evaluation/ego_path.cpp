// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/ego_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/true_frames.hpp"

namespace lanefuse {
namespace {

constexpr double kReach =
    distance_at(kDistanceCount - 1) + 20;     // [m] so that what is measured across the path finds its foot
constexpr double kYawRateTimeConstant = 0.5;  // [s]
constexpr double kSlowest = 1.0;              // [m/s] for a curvature from the yaw rate

/// The centre of the ego lane at x, where both of its boundaries reach it.
std::optional<double> centre_at(const LaneEstimate& estimate, double x) {
  const Lane* lane = ego_lane(estimate);
  if (!lane) return std::nullopt;
  const Boundary& left = *find_boundary(estimate, lane->left_boundary);
  const Boundary& right = *find_boundary(estimate, lane->right_boundary);
  if (x < std::max(left.range_begin, right.range_begin) || x > std::min(left.range_end, right.range_end)) {
    return std::nullopt;
  }
  return (lateral_at(left, x) + lateral_at(right, x)) / 2;
}

/// Where a circle that leaves the origin along x crosses `x`, or nothing if it turns back before.
std::optional<double> circle_at(double curvature, double x) {
  const double sine = curvature * x;
  if (std::abs(sine) >= 1) return std::nullopt;
  return sine * x / (1 + std::sqrt(1 - sine * sine));
}

std::optional<double> deviation_of(std::optional<double> y, double x, const LineAhead& path) {
  return y ? std::optional(path.deviation({x, *y})) : std::nullopt;
}

}  // namespace

std::optional<LineAhead> driven_path(std::span<const TrueFrame> frames, Time time, double reach) {
  const std::optional<TrueFrame> here = frame_at(frames, time);
  if (!here) return std::nullopt;
  const Pose2 vehicle_from_world = here->world_from_vehicle.inverse();
  LineAhead path;
  path.extend({0, 0});
  Time last = time;
  auto next = std::upper_bound(frames.begin(), frames.end(), time,
                               [](Time t, const TrueFrame& frame) { return t < frame.time; });
  for (; next != frames.end() && path.points().back().x() < reach; last = next->time, ++next) {
    const Pose2 there = vehicle_from_world * next->world_from_vehicle;
    if (next->time - last > kLargestFrameGap || std::cos(there.heading) <= 0) break;
    path.extend(there.position());
  }
  return path;
}

void SmoothedYawRate::add(Time time, double yaw_rate) {
  const double share = last_ ? 1 - std::exp(-to_seconds(time - *last_) / kYawRateTimeConstant) : 1.0;
  value_ += share * (yaw_rate - value_);
  last_ = time;
}

void EgoPathEvaluation::add(const LaneEstimate& estimate, bool vehicle_ahead) {
  ++counts_.cycles;
  if (estimate.status == EstimateStatus::ok) ++counts_.cycles_ok;
  yaw_rate_.add(estimate.time, estimate.yaw_rate);
  const std::optional<LineAhead> path = driven_path(frames_, estimate.time, kReach);
  if (!path) return;
  ++counts_.cycles_with_truth;
  const double curvature = estimate.speed < kSlowest ? 0 : yaw_rate_.value() / estimate.speed;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    if (!path->y(distance_at(i))) continue;
    const bool reached = compare_centre(estimate, *path, i);
    compare_baselines(curvature, *path, i, reached);
    if (!vehicle_ahead) continue;
    ++with_vehicle_ahead_[i].cycles;
    if (reached) ++with_vehicle_ahead_[i].reached;
  }
}

bool EgoPathEvaluation::compare_centre(const LaneEstimate& estimate, const LineAhead& path,
                                       std::size_t distance_index) {
  const double x = distance_at(distance_index);
  const std::optional<double> centre = centre_at(estimate, x);
  centre_.add(distance_index, deviation_of(centre, x, path));
  return centre.has_value();
}

void EgoPathEvaluation::compare_baselines(double curvature, const LineAhead& path, std::size_t distance_index,
                                          bool available) {
  const double x = distance_at(distance_index);
  const auto compare = [&](std::optional<double> y, Baseline& baseline) {
    const std::optional<double> deviation = deviation_of(y, x, path);
    baseline.all.add(distance_index, deviation);
    if (available) baseline.where_available.add(distance_index, deviation);
  };
  compare(0.0, straight_);
  compare(circle_at(curvature, x), arc_);
}

EvaluationResult EgoPathEvaluation::result() const {
  EvaluationResult result = counts_;
  result.truth = "ego-path";
  result.lanes.ego = centre_.statistics();
  result.baselines = {straight_.all.statistics(), arc_.all.statistics(),
                      straight_.where_available.statistics(), arc_.where_available.statistics()};
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    const auto [reached, cycles] = with_vehicle_ahead_[i];
    const double share = cycles == 0 ? std::numeric_limits<double>::quiet_NaN()
                                     : static_cast<double>(reached) / static_cast<double>(cycles);
    result.availability_with_vehicle_ahead.push_back({distance_at(i), share, cycles});
  }
  return result;
}

}  // namespace lanefuse
