// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/exact_truth.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "evaluation/false_lanes.hpp"
#include "evaluation/serial_camera_baseline.hpp"

namespace lanefuse {
namespace {

constexpr std::array<double, 6> kVehicleCounts{0, 1, 3, 5, 7, 10};
constexpr std::array<double, 7> kGaps{0, 20, 40, 60, 80, 100, 120};  // [m]
constexpr double kNoneAhead = std::numeric_limits<double>::max();    // counts with the largest gaps

}  // namespace

ExactTruthEvaluation::ExactTruthEvaluation(const TrueRoad& road,
                                           const std::optional<SurveyedTruthConfig>& survey)
    : view_(road), lanes_(road), survey_(survey), by_vehicles_ahead_(kVehicleCounts), by_gap_ahead_(kGaps) {
  if (survey_) survey_error_.emplace(*survey_);
}

void ExactTruthEvaluation::add_without_truth(const LaneEstimate& estimate) {
  ++counts_.cycles;
  if (estimate.status == EstimateStatus::ok) ++counts_.cycles_ok;
  resets_.add(estimate);
}

void ExactTruthEvaluation::add(const LaneEstimate& estimate, const TrueFrame& frame,
                               const LaneEstimate* serial_camera) {
  assert(frame.time == estimate.time);
  add_without_truth(estimate);
  if (survey_error_) survey_error_->advance(frame.time, frame.world_from_vehicle.position());
  const TrueRoles roles = lanes_.roles(view_.look_from(frame.world_from_vehicle));
  if (roles[kEgoLeft].empty()) return;
  ++counts_.cycles_with_truth;
  judge_lanes(estimate, roles);
  const TrueRoles truth = as_surveyed(roles);
  const std::vector<RoleDeviation> deviations = compare(estimated_roles(estimate, truth), truth);
  for (const RoleDeviation& one : deviations) {
    deviations_.add(one);
    consistency_.add(one);
  }
  const TrafficAhead traffic = traffic_ahead(frame, roles);
  by_vehicles_ahead_.add(traffic.vehicles, deviations);
  by_gap_ahead_.add(traffic.gap.value_or(kNoneAhead), deviations);
  if (serial_camera) judge_serial_camera(*serial_camera, truth);
  keep_trace(deviations, frame);
}

TrueRoles ExactTruthEvaluation::as_surveyed(TrueRoles roles) const {
  if (!survey_error_) return roles;
  for (std::size_t role = 0; role < kRoleCount; ++role) {
    roles[role] = survey_error_->surveyed(roles[role], static_cast<LaneRole>(role));
  }
  return roles;
}

void ExactTruthEvaluation::judge_lanes(const LaneEstimate& estimate, const TrueRoles& truth) {
  const FalseCounts counts = count_false(estimate, lanes_, view_.lines());
  counts_.false_boundaries += counts.boundaries;
  counts_.false_lanes += counts.lanes;
  const EstimatedRoles estimated = estimated_roles(estimate, truth);
  if (!estimated[kEgoLeft]) return;
  ++counts_.cycles_with_ego_lane;
  if (in_wrong_lane(estimated, truth, lanes_, view_.lines())) ++counts_.cycles_in_wrong_lane;
}

void ExactTruthEvaluation::judge_serial_camera(const LaneEstimate& serial_camera, const TrueRoles& truth) {
  if (!serial_camera_) serial_camera_.emplace();
  for (const RoleDeviation& one : compare(estimated_roles(serial_camera, truth), truth)) {
    serial_camera_->within_range.add(one);
  }
  const LaneEstimate far = extrapolated(serial_camera, distance_at(kDistanceCount - 1));
  for (const RoleDeviation& one : compare(estimated_roles(far, truth), truth))
    serial_camera_->extrapolated.add(one);
}

void ExactTruthEvaluation::keep_trace(const std::vector<RoleDeviation>& deviations, const TrueFrame& frame) {
  ErrorAtPlace here{frame.world_from_vehicle.position(), std::numeric_limits<double>::quiet_NaN()};
  for (const RoleDeviation& one : deviations) {
    if (!is_ego(one.role) || one.distance_index != kTraceDistanceIndex || !one.deviation) continue;
    here.error = std::fmax(here.error, std::abs(*one.deviation));
  }
  trace_.push_back(here);
}

EvaluationResult ExactTruthEvaluation::result() const {
  EvaluationResult result = counts_;
  result.truth = survey_ ? "surveyed" : "exact";
  result.surveyed = survey_;
  result.lanes = deviations_.statistics();
  result.consistency = consistency_.statistics();
  result.resets = resets_.count();
  result.by_vehicles_ahead = by_vehicles_ahead_.statistics();
  result.by_gap_ahead = by_gap_ahead_.statistics();
  if (serial_camera_) {
    result.serial_camera = {serial_camera_->extrapolated.statistics().ego,
                            serial_camera_->within_range.statistics().ego};
  }
  return result;
}

}  // namespace lanefuse
