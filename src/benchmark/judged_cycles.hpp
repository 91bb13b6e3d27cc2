// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/lane_estimate.hpp"
#include "evaluation/exact_truth.hpp"
#include "evaluation/tracking_judge.hpp"
#include "sensors/measurement.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// Judges a drive while it is being driven: estimates wait until the truth around their time has come, so
/// that neither the one nor the other is held for longer than that.
class JudgedCycles {
 public:
  /// `road` must outlive this.
  JudgedCycles(const TrueRoad& road, const std::optional<SurveyedTruthConfig>& survey)
      : evaluation_(road, survey) {}
  JudgedCycles(TrueRoad&&, const std::optional<SurveyedTruthConfig>&) = delete;

  /// The truth, in order of time.
  void add(const std::vector<TrueFrame>& frames);

  /// An estimate, in order of time, what the serial camera alone says at the same time, and the vehicles
  /// tracked then.
  void add(const LaneEstimate& estimate, LaneEstimate serial_camera, std::span<const TrackedObject> objects) {
    waiting_.push_back({estimate, std::move(serial_camera), {objects.begin(), objects.end()}});
  }

  /// Judges what still waits, and says what came of it all.
  EvaluationResult finish();

 private:
  struct Cycle {
    LaneEstimate estimate;
    LaneEstimate serial_camera;
    std::vector<TrackedObject> objects;
  };

  void judge(const Cycle& cycle);
  void forget_frames();

  ExactTruthEvaluation evaluation_;
  TrackingJudge tracking_{TrackingJudgeConfig{}};
  std::vector<TrueFrame> frames_;
  std::vector<Cycle> waiting_;
};

}  // namespace lanefuse
