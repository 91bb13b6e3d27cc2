// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/estimator.hpp"
#include "core/lane_availability.hpp"
#include "core/lane_estimate.hpp"
#include "pipeline/config.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "sources/camera_images.hpp"
#include "sources/dead_reckoning.hpp"
#include "sources/feature_source.hpp"
#include "sources/lane_width_filter.hpp"

namespace lanefuse {

/// Multi-lane perception, whole: the paper's Fig. 1. Measurements go in, in the order in which they were
/// received; cycles come out on a fixed clock over recorded time.
///
///     MultiLanePerception perception(config, rig);
///     for (const Measurement& measurement : drive) {
///       while (const LaneEstimate* lanes = perception.advance(stamp_of(measurement).received_at))
///       use(*lanes); perception.add(measurement);
///     }
///
/// Not safe to share between threads. Nothing in here reads a clock or a file.
class MultiLanePerception {
 public:
  MultiLanePerception(const PerceptionConfig& config, Rig rig);

  /// Adds a source of the user's own beside the built-in ones; from then on it is asked in every cycle.
  void add_source(std::unique_ptr<FeatureSource> source) { sources_.push_back(std::move(source)); }

  /// Takes a measurement in. What is impossible is rejected, what comes twice or too late dropped; both are
  /// counted in the next cycle's inputs.
  void add(Measurement measurement);

  /// Runs the next cycle if it was due before `now`, on all that had been received by its time. Null when
  /// none is due; the result is valid until the next call.
  const LaneEstimate* advance(Time now);

  [[nodiscard]] const DebugView& debug() const { return estimator_->debug(); }

  /// What the cameras saw in the images that the last cycle took in.
  [[nodiscard]] std::span<const CameraView> camera_views() const { return images_.views(); }

  /// The vehicles that the last cycle tracked, in the vehicle frame at its time: from detections by the own
  /// tracker, else as an object list gave them.
  [[nodiscard]] std::span<const TrackedObject> objects() const;

  /// The ids of the object sensors that are left out, as they contradict themselves or the others.
  [[nodiscard]] std::span<const std::uint32_t> distrusted_sensors() const;

  /// Lets the caller time the stages: called when one ends.
  void on_stage(LaneEstimator::StageListener listener);

  /// What fuses: for those who want to see more of it than every estimator shows (GraphEstimator::on_window).
  [[nodiscard]] LaneEstimator& estimator() { return *estimator_; }

  /// Forgets everything, as after construction.
  void reset();

 private:
  void run_sources(Time now);
  void take(const Measurement& measurement, const SourceContext& context);
  InputAccounting hand_to_sources(const Measurement& measurement, const SourceContext& context);
  InputAccounting take_image(const CameraImage& image, const SourceContext& context);
  void judge_cameras(LaneEstimate& estimate) const;
  void judge_object_sensors(LaneEstimate& estimate) const;
  bool seen_before(const Measurement& measurement);
  [[nodiscard]] bool is_long_past(const Measurement& measurement) const;
  [[nodiscard]] bool clock_was_set_back(const Measurement& measurement);
  [[nodiscard]] Time last_cycle_until(Time time) const;
  void judge_sources(Time now, LaneEstimate& estimate) const;

  PerceptionConfig config_;
  Rig rig_;
  Duration period_;
  Duration stamp_memory_;  ///< longer than the reorder window, so that what comes twice is still known
  DeadReckoning dead_reckoning_;
  LaneWidthFilter lane_width_;
  CameraImages images_;
  std::vector<std::unique_ptr<FeatureSource>> sources_;
  const ObjectSource* objects_ = nullptr;  ///< one of them, if it is enabled
  std::unique_ptr<LaneEstimator> estimator_;
  LaneAvailability availability_;
  LaneEstimator::StageListener stage_done_ = [](Stage) {};

  std::vector<Measurement> pending_;
  std::vector<FeatureSet> feature_sets_;
  std::optional<Time> next_cycle_;
  std::optional<Time> long_past_since_;  ///< no stamp but long past ones since this one
  std::uint32_t restarts_ = 0;
  InputAccounting inputs_;
  /// Stamps of the last moments, a kind and sensor: a message that comes twice is taken once.
  std::map<std::pair<std::size_t, std::uint32_t>, std::set<Time>> stamps_;
  std::map<Source, Time> last_heard_;
  LaneEstimate estimate_;
};

}  // namespace lanefuse
