// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "core/feature.hpp"
#include "core/lane_estimate.hpp"
#include "core/motion.hpp"
#include "core/time.hpp"

namespace lanefuse {

/// All that one cycle may know.
struct Cycle {
  Time time{};
  /// Dead reckoning in order of time, reaching back to the oldest stamp in `features`. The frame that they
  /// share must be the same in every cycle until reset(). Empty where there is no odometry.
  std::span<const MotionSample> motion;
  std::span<const FeatureSet> features;
};

/// Turns features and motion into lanes. The paper's graph and the road-level estimator both are one.
/// No clock, no input or output inside: the same cycles give the same estimates.
class LaneEstimator {
 public:
  /// Is told when a stage of the cycle ends; lets the caller, who owns the clock, time the stages.
  using StageListener = std::function<void(Stage)>;

  virtual ~LaneEstimator() = default;

  /// Runs one cycle; `cycle.time` must be later than that of the cycle before. The result is valid until the
  /// next call. It never throws for bad data: what cannot be believed is rejected and counted.
  virtual const LaneEstimate& process(const Cycle& cycle) = 0;

  /// Forgets everything, as after construction.
  virtual void reset() = 0;

  /// What the last cycle looked like inside.
  [[nodiscard]] virtual const DebugView& debug() const = 0;

  virtual void on_stage(StageListener listener) = 0;
};

}  // namespace lanefuse
