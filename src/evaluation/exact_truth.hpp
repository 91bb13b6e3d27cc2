// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/lane_estimate.hpp"
#include "evaluation/error_trace.hpp"
#include "evaluation/evaluation_result.hpp"
#include "evaluation/lane_roles.hpp"
#include "evaluation/reset_counter.hpp"
#include "evaluation/role_comparison.hpp"
#include "evaluation/surveyed_truth.hpp"
#include "evaluation/traffic_ahead.hpp"
#include "evaluation/true_road_view.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// Compares estimated boundaries with the true ones, as the paper's Table I does [IROS16, sec. III].
///
/// Ego are both boundaries of the lane that the car's origin truly is in; adjacent are the outer boundaries
/// of its left and right neighbour, where those lanes exist: see TrueLanes. The estimate answers with the
/// boundaries of its own ego lane and of its own neighbours: who takes one lane for another is a lane's width
/// off, and that counts. A boundary answers at d if range_begin <= d <= range_end; the point (d, y(d)) is
/// then measured across the true line.
///
/// With a survey's error, the deviations (and what follows from them: consistency, conditions, the serial
/// camera) are from the true lines as the survey has them. Which lane is whose, and what is false, is judged
/// by the road itself: decimetres make no other lane.
class ExactTruthEvaluation {
 public:
  /// `road` must outlive the evaluation.
  explicit ExactTruthEvaluation(const TrueRoad& road, const std::optional<SurveyedTruthConfig>& survey = {});
  explicit ExactTruthEvaluation(TrueRoad&&, const std::optional<SurveyedTruthConfig>& = {}) = delete;

  /// `frame` is the truth at the estimate's time: see frame_at(). `serial_camera` is what that camera alone
  /// says at the same time (see SerialCameraBaseline); it is judged beside the estimate and changes nothing.
  void add(const LaneEstimate& estimate, const TrueFrame& frame, const LaneEstimate* serial_camera = nullptr);

  /// A cycle for which no true frame exists: it counts as a cycle, and is not judged.
  void add_without_truth(const LaneEstimate& estimate);

  [[nodiscard]] EvaluationResult result() const;

  /// Where the error was how large, in order of time; grows with the drive by 24 bytes a cycle.
  [[nodiscard]] const ErrorTrace& trace() const { return trace_; }

 private:
  [[nodiscard]] TrueRoles as_surveyed(TrueRoles roles) const;
  void judge_lanes(const LaneEstimate& estimate, const TrueRoles& truth);
  void judge_serial_camera(const LaneEstimate& serial_camera, const TrueRoles& truth);
  void keep_trace(const std::vector<RoleDeviation>& deviations, const TrueFrame& frame);

  struct SerialCamera {
    RoleDeviations extrapolated;
    RoleDeviations within_range;
  };

  TrueRoadView view_;
  TrueLanes lanes_;
  std::optional<SurveyedTruthConfig> survey_;
  std::optional<SurveyError> survey_error_;
  RoleDeviations deviations_;
  RoleConsistency consistency_;
  ConditionedDeviations by_vehicles_ahead_;
  ConditionedDeviations by_gap_ahead_;
  std::optional<SerialCamera> serial_camera_;
  ResetCounter resets_;
  EvaluationResult counts_;
  ErrorTrace trace_;
};

}  // namespace lanefuse
