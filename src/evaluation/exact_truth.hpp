// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "core/lane_estimate.hpp"
#include "evaluation/consistency.hpp"
#include "evaluation/deviation.hpp"
#include "evaluation/evaluation_result.hpp"
#include "evaluation/true_road_view.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// Compares estimated boundaries with the true ones, as the paper's Table I does [IROS16, sec. III].
///
/// Ego are both boundaries of the lane that the car's origin truly is in; adjacent are the outer boundaries
/// of its left and right neighbour, where those lanes exist. The estimate answers with the boundaries of its
/// own ego lane and of its own neighbours: who takes one lane for another is a lane's width off, and that
/// counts. A boundary answers at d if range_begin <= d <= range_end; the point (d, y(d)) is then measured
/// across the true line.
class ExactTruthEvaluation {
 public:
  /// `road` must outlive the evaluation.
  explicit ExactTruthEvaluation(const TrueRoad& road) : road_(road), view_(road) {}
  explicit ExactTruthEvaluation(TrueRoad&&) = delete;

  /// `frame` is the truth at the estimate's time: see frame_at().
  void add(const LaneEstimate& estimate, const TrueFrame& frame);

  /// A cycle for which no true frame exists: it counts as a cycle, and is not judged.
  void add_without_truth(const LaneEstimate& estimate);

  [[nodiscard]] EvaluationResult result() const;

 private:
  struct Group {
    DeviationByDistance deviations;
    ConsistencyByDistance consistency;
  };

  static void compare(const Boundary* estimated, const LineAhead& truth, Group& group);
  void judge_assignment(const LaneEstimate& estimate, const LineAhead& true_left,
                        const LineAhead& true_right);
  void count_false_boundaries(const LaneEstimate& estimate);

  const TrueRoad& road_;
  TrueRoadView view_;
  Group ego_;
  Group adjacent_;
  EvaluationResult counts_;
};

}  // namespace lanefuse
