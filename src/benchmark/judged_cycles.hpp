// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/lane_estimate.hpp"
#include "evaluation/exact_truth.hpp"
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

  /// An estimate, in order of time, and what the serial camera alone says at the same time.
  void add(const LaneEstimate& estimate, LaneEstimate serial_camera) {
    waiting_.emplace_back(estimate, std::move(serial_camera));
  }

  /// Judges what still waits, and says what came of it all.
  EvaluationResult finish();

 private:
  using Cycle = std::pair<LaneEstimate, LaneEstimate>;

  void judge(const Cycle& cycle);
  void forget_frames();

  ExactTruthEvaluation evaluation_;
  std::vector<TrueFrame> frames_;
  std::vector<Cycle> waiting_;
};

}  // namespace lanefuse
