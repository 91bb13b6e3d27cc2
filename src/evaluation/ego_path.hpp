// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/lane_estimate.hpp"
#include "evaluation/deviation.hpp"
#include "evaluation/evaluation_result.hpp"
#include "evaluation/line_ahead.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// The path that the car drove after `time`, in its frame at `time`, up to `reach` [m] ahead: only the part
/// that goes forward, and less of it where the drive or the truth ends. Nothing where there is no true pose
/// at `time`.
std::optional<LineAhead> driven_path(std::span<const TrueFrame> frames, Time time, double reach);

/// The current yaw rate, smoothed by an exponential filter with a time constant of 0.5 s: it averages as
/// much, and lags as much, as the mean over the last second would.
class SmoothedYawRate {
 public:
  void add(Time time, double yaw_rate);
  [[nodiscard]] double value() const { return value_; }

 private:
  std::optional<Time> last_;
  double value_ = 0;
};

/// Compares the centre of the estimated ego lane with the path that the car drove later: for drives whose
/// only truth is where the car went. The driver's own wandering within the lane is in every figure.
///
/// The centre is the mean of both boundaries' y at x = d, and is available where both reach d. Baselines
/// stand on nothing but the path: straight ahead, and the circle of the smoothed yaw rate at the estimate's
/// speed (straight below 1 m/s, where a curvature means nothing).
class EgoPathEvaluation {
 public:
  /// `frames`, in order of time, must outlive the evaluation.
  explicit EgoPathEvaluation(std::span<const TrueFrame> frames) : frames_(frames) {}

  /// Estimates come in order of time. `vehicle_ahead`: a moving vehicle is tracked ahead in this cycle.
  void add(const LaneEstimate& estimate, bool vehicle_ahead);

  [[nodiscard]] EvaluationResult result() const;

 private:
  struct Baseline {
    DeviationByDistance all;
    DeviationByDistance where_available;
  };
  struct Reach {
    std::uint64_t reached = 0;
    std::uint64_t cycles = 0;
  };

  /// Returns whether the estimate reached this distance.
  bool compare_centre(const LaneEstimate& estimate, const LineAhead& path, std::size_t distance_index);
  void compare_baselines(double curvature, const LineAhead& path, std::size_t distance_index, bool available);

  std::span<const TrueFrame> frames_;
  SmoothedYawRate yaw_rate_;
  DeviationByDistance centre_;
  Baseline straight_;
  Baseline arc_;
  std::array<Reach, kDistanceCount> with_vehicle_ahead_{};
  EvaluationResult counts_;
};

}  // namespace lanefuse
