// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/estimator.hpp"
#include "road/impossible_inputs.hpp"
#include "road/lane_births.hpp"
#include "road/lane_writer.hpp"
#include "road/line_births.hpp"
#include "road/paint_update.hpp"
#include "road/road_config.hpp"
#include "road/road_state.hpp"
#include "road/tracked_lane_update.hpp"
#include "road/vehicle_update.hpp"

namespace lanefuse {

/// The road-level estimator: one filter over the road's course, its lines, the vehicles on it and what is
/// wrong with the sensors. See docs/road.md.
class RoadEstimator final : public LaneEstimator {
 public:
  explicit RoadEstimator(const RoadConfig& config);

  const LaneEstimate& process(const Cycle& cycle) override;
  void reset() override;
  [[nodiscard]] const DebugView& debug() const override { return debug_; }
  void on_stage(StageListener listener) override { stage_done_ = std::move(listener); }

  [[nodiscard]] const RoadState& state() const { return state_; }

 private:
  void give_up(StatusReason reason);
  void drive(const Pose2& odometry_from_vehicle, Time now);
  void take(const FeatureSet& set, const Cycle& cycle, const Pose2& odometry_from_vehicle);
  void take_features(const FeatureSet& set, const Pose2& now_from_measured);
  void judge();
  [[nodiscard]] bool has_lost_the_road();
  void forget_road();

  RoadConfig config_;
  ImpossibleInputs impossible_;
  RoadState state_;
  PaintUpdate paint_;
  TrackedLaneUpdate tracked_lane_;
  VehicleUpdate vehicles_;
  LineBirths births_;
  LaneBirths lane_births_;
  LaneWriter writer_;
  StageListener stage_done_ = [](Stage) {};
  std::optional<Pose2> last_odometry_from_vehicle_;
  Time last_cycle_{};
  double tracked_taken_at_ = 0;  ///< [m] driven
  double paint_taken_at_ = 0;    ///< [m] driven
  LaneWidth usual_width_;
  int lost_frames_ = 0;  ///< in which most of the paint was of no line
  LaneEstimate estimate_;
  DebugView debug_;
};

}  // namespace lanefuse
