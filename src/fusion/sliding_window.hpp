// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/feature.hpp"
#include "core/time.hpp"
#include "fusion/fusion_config.hpp"
#include "graph/window_graph.hpp"

namespace lanefuse {

/// What ties two features of the window.
enum class TieKind : std::uint32_t { width = 0, smoothing = 1 };

/// What a tie of the window is, beside the graph's own.
struct TieOrigin {
  std::int64_t track_id = kNoTrack;
  Side side = Side::none;
};

/// A constraint between two features, with the information in the frame of the measurement.
struct FeatureTie {
  WindowGraph::Id from, to;
  Pose2 measurement;
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
};

/// What a keyframe of the car's own path is, beside the graph's own pose.
struct Keyframe {
  Time time{};
  Pose2 odometry_from_vehicle;  ///< as dead-reckoned
};

/// What a fused lane feature is, beside the graph's own landmark.
struct WindowFeature {
  Time time{};            ///< of its last measurement
  double confidence = 0;  ///< in [0, 1]
  MarkingEvidence marking;
  std::int64_t track_id = kNoTrack;                ///< the last tracked thing that witnessed it
  Side side = Side::none;                          ///< and on which side of it
  std::array<std::uint16_t, kSourceCount> hits{};  ///< measurements, a source
};

/// Who measured: a second look of the same sensor from the same keyframe replaces its first.
struct Witness {
  Source source = Source::user;
  std::uint32_t sensor_id = 0;
};

/// The graph over the last stretch of road [IROS16, sec. II-E]: keyframes x_{t-tau:t}, lane features
/// f_1..f_n, and the constraints between them.
///
/// Inside, everything stands in the frame of the dead reckoning. The newest keyframe is held at its
/// dead-reckoned pose (the gauge), so that frame stays the newest keyframe's frame moved by odometry alone,
/// and no vertex has to be rewritten as the car drives on. The vehicle frame is made at the output.
///
/// Ids are the graph's: a feature keeps its id until it is forgotten, in `prune` only.
class SlidingWindow {
 public:
  using Id = WindowGraph::Id;

  explicit SlidingWindow(const FusionConfig& config);

  /// Moves the window on to `time`: adds a keyframe if the car has moved far enough since the last one.
  void advance(Time time, const Pose2& odometry_from_vehicle);

  /// The keyframe nearest in time to `time`. The window must not be empty.
  [[nodiscard]] Id nearest_keyframe(Time time) const;

  /// Where the vehicle was, in the window's frame, when it measured at `odometry_from_vehicle`, next to
  /// `keyframe`.
  [[nodiscard]] Pose2 window_from_vehicle(Id keyframe, const Pose2& odometry_from_vehicle) const;

  /// Whether it holds as many measurements as it may.
  [[nodiscard]] bool is_full_of_measurements() const {
    return graph_.observation_count() >= config_.max_measurements;
  }

  /// A new feature, or nothing where the window is full.
  std::optional<Id> add_feature(const Pose2& window_from_feature, Time measured_at);

  /// Ties a feature to a keyframe; the information is in the feature's measured frame. A second measurement
  /// by the same sensor from the same keyframe replaces the first: a standing car learns nothing new by
  /// looking again, and the window stays bounded. Returns whether it was the first.
  bool add_measurement(Id keyframe, Id feature, const Pose2& seen, const PlanarInformation& information,
                       const Witness& witness);

  /// Adds a width or smoothing edge unless the two features are one, or are tied like this already, or the
  /// window is full.
  void add_tie(TieKind kind, const FeatureTie& tie, const TieOrigin& origin);

  /// Forgets features that are behind, beyond reach or stale; of what is left the least informative, as far
  /// as the bounds of the configuration ask for room; then keyframes that no measurement holds. A keyframe
  /// that falls out of the middle leaves the composition of its two odometry edges.
  void prune(Time now, const Pose2& odometry_from_vehicle);

  void clear();

  [[nodiscard]] bool empty() const { return graph_.chain().empty(); }
  [[nodiscard]] std::size_t feature_count() const { return graph_.landmark_count(); }
  [[nodiscard]] std::size_t keyframe_count() const { return graph_.chain().size(); }
  [[nodiscard]] std::size_t edge_count() const;
  /// Features forgotten for want of room, since the beginning.
  [[nodiscard]] std::uint64_t crowded_out() const { return crowded_out_; }
  [[nodiscard]] const WindowGraph& graph() const { return graph_; }
  [[nodiscard]] WindowGraph& graph() { return graph_; }
  [[nodiscard]] const Keyframe& keyframe(Id id) const { return keyframes_[id]; }
  [[nodiscard]] const WindowFeature& feature(Id id) const { return features_[id]; }
  [[nodiscard]] WindowFeature& feature(Id id) { return features_[id]; }
  [[nodiscard]] const TieOrigin& origin(Id tie) const { return origins_[tie]; }

 private:
  void forget_features(Time now, const Pose2& vehicle_from_odometry);
  void make_room(Time now);
  void forget_keyframes();

  const FusionConfig& config_;
  WindowGraph graph_;
  std::vector<Keyframe> keyframes_;                    ///< by pose
  std::vector<WindowFeature> features_;                ///< by landmark
  std::vector<TieOrigin> origins_;                     ///< by tie
  std::vector<std::pair<double, Id>> by_information_;  ///< scratch: a heap, the least on top
  std::uint64_t crowded_out_ = 0;
};

}  // namespace lanefuse
