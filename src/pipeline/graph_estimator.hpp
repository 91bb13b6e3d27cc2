// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/estimator.hpp"
#include "fusion/feature_fusion.hpp"
#include "lanes/lane_model.hpp"

namespace lanefuse {

/// The paper's estimator: lane feature fusion by GraphSLAM, then multi-lane modelling [IROS16, Fig. 1].
class GraphEstimator final : public LaneEstimator {
 public:
  GraphEstimator(const FusionConfig& fusion, const LaneModelConfig& lanes);
  GraphEstimator(const GraphEstimator&) = delete;
  GraphEstimator& operator=(const GraphEstimator&) = delete;

  const LaneEstimate& process(const Cycle& cycle) override;
  void reset() override;
  [[nodiscard]] const DebugView& debug() const override { return debug_; }
  void on_stage(StageListener listener) override { stage_done_ = std::move(listener); }

  /// See FeatureFusion::on_window.
  void on_window(FeatureFusion::WindowListener listener) { fusion_.on_window(std::move(listener)); }

  /// See FeatureFusion::use_solver.
  void use_solver(std::unique_ptr<WindowSolver> solver) { fusion_.use_solver(std::move(solver)); }

 private:
  Pose2 moved_since_last_cycle(const Cycle& cycle);
  void give_up(StatusReason reason);

  FusionConfig fusion_config_;
  LaneModelConfig lanes_config_;
  FeatureFusion fusion_;
  LaneModel lanes_;
  StageListener stage_done_ = [](Stage) {};
  std::optional<Pose2> last_odometry_from_vehicle_;
  LaneEstimate estimate_;
  DebugView debug_;
};

}  // namespace lanefuse
