// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/estimator.hpp"
#include "road/road_config.hpp"

namespace lanefuse {

/// The road-level estimator: one filter over the road's course, its markings, the vehicles on it and what is
/// wrong with the sensors. See docs/road.md.
class RoadEstimator final : public LaneEstimator {
 public:
  explicit RoadEstimator(const RoadConfig& config) : config_(config) {}

  const LaneEstimate& process(const Cycle& cycle) override;
  void reset() override;
  [[nodiscard]] const DebugView& debug() const override { return debug_; }
  void on_stage(StageListener listener) override { stage_done_ = std::move(listener); }

 private:
  RoadConfig config_;
  StageListener stage_done_ = [](Stage) {};
  LaneEstimate estimate_;
  DebugView debug_;
};

}  // namespace lanefuse
