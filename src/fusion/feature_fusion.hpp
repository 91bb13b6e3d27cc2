// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/estimator.hpp"
#include "core/feature.hpp"
#include "core/lane_estimate.hpp"
#include "fusion/association.hpp"
#include "fusion/fusion_config.hpp"
#include "fusion/sliding_window.hpp"
#include "graph/window_solver.hpp"

namespace lanefuse {

/// What a cycle of the fusion came to.
struct FusionResult {
  bool has_motion = false;  ///< without it nothing was done
  SolveResult solve;
  InputAccounting
      features;  ///< measured features: used, rejected as impossible, dropped as too late or too many
};

/// Lane feature fusion [IROS16, Fig. 1 and secs. II-D, II-E]: accumulates the feature sets F_1..F_N in a
/// sliding-window graph and gives back F_fused. It has no model of the road's shape.
///
/// Not safe to share between threads.
class FeatureFusion {
 public:
  /// `config` must outlive the fusion.
  FeatureFusion(const FusionConfig& config, std::unique_ptr<WindowSolver> solver);

  /// Is shown the window of each cycle right before it is solved: the newest keyframe fixed, all others and
  /// the features where the last cycle left them.
  using WindowListener = std::function<void(const WindowGraph&)>;
  void on_window(WindowListener listener) { window_listener_ = std::move(listener); }

  /// From the next cycle on.
  void use_solver(std::unique_ptr<WindowSolver> solver) { solver_ = std::move(solver); }

  FusionResult process(const Cycle& cycle, const LaneEstimator::StageListener& stage_done);

  /// F_fused in the vehicle frame of the last cycle: one feature a vertex, with its confidence and the
  /// covariance that its own measurements leave it.
  [[nodiscard]] std::span<const Feature> fused() const { return fused_; }

  /// Every smoothing edge and what its switch says.
  void switch_states(std::vector<SwitchState>& out) const;

  [[nodiscard]] GraphSize size() const;
  [[nodiscard]] const SlidingWindow& window() const { return window_; }

  void reset();

 private:
  using Id = SlidingWindow::Id;
  struct Attachment;
  /// The feature that one side of a track touched last: where its next smoothing edge starts.
  struct TrackEnd {
    std::int64_t track_id;
    Side side;
    Id feature;
    Time time;
  };
  void add_set(const FeatureSet& set, const Cycle& cycle, InputAccounting& accounting);
  void sample_within_reach(ClothoidMeasurement clothoid);
  /// The fused feature that now holds the measured one; kNone where it would be a new one and the window is
  /// full.
  Id add_feature(const Feature& feature, const Attachment& at);
  void raise_confidence(Id id, const Feature& feature, Source source);
  void remember(Id id, const Feature& feature, const Attachment& at);
  void tie(const FeatureSet& set);
  void smooth(const Feature& feature, Id fused, Time measured_at);
  void forget_tracks(Time now);
  void read_out();

  const FusionConfig& config_;
  std::unique_ptr<WindowSolver> solver_;
  WindowListener window_listener_;
  SlidingWindow window_;
  FeatureAssociation association_;
  Pose2 odometry_from_vehicle_;  ///< at the cycle's time
  std::vector<Feature> fused_;
  std::vector<Feature> sampled_;  ///< scratch: a set's features and the samples of its clothoids
  std::vector<Id> fused_of_;      ///< scratch: beside sampled_, where each feature went
  std::vector<TrackEnd> track_ends_;
};

}  // namespace lanefuse
