// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/feature.hpp"
#include "core/time.hpp"
#include "fusion/fusion_config.hpp"
#include "graph/pose_graph.hpp"

namespace lanefuse {

enum class EdgeKind : std::uint8_t { odometry = 0, measurement = 1, width = 2, smoothing = 3 };

/// What an edge of the window is, beside the graph's own Edge of the same index.
struct EdgeOrigin {
  EdgeKind kind = EdgeKind::odometry;
  Source source = Source::user;
  std::uint32_t sensor_id = 0;
  std::int64_t track_id = kNoTrack;
  Side side = Side::none;
};

/// What a vertex of the window is, beside the graph's own Vertex of the same index: a keyframe of the car's
/// own path, or a fused lane feature.
struct WindowVertex {
  VertexRole role = VertexRole::pose;
  Time time{};                                     ///< a keyframe's stamp; a feature's last measurement
  Pose2 odometry_from_vehicle;                     ///< a keyframe's dead-reckoned pose
  double confidence = 0;                           ///< of a feature
  MarkingEvidence marking;                         ///< of a feature
  std::int64_t track_id = kNoTrack;                ///< the last tracked thing that witnessed a feature
  Side side = Side::none;                          ///< and on which side of it
  std::array<std::uint16_t, kSourceCount> hits{};  ///< measurements of a feature, a source
};

/// The graph over the last stretch of road [IROS16, sec. II-E]: keyframes x_{t-tau:t}, lane features
/// f_1..f_n, and the constraints between them.
///
/// Inside, everything stands in the frame of the dead reckoning. The newest keyframe is held at its
/// dead-reckoned pose (the gauge), so that frame stays the newest keyframe's frame moved by odometry alone,
/// and no vertex has to be rewritten as the car drives on. The vehicle frame is made at the output.
///
/// Ids of vertices are indices; they change in `prune` only.
class SlidingWindow {
 public:
  explicit SlidingWindow(const FusionConfig& config) : config_(config) {}

  /// Moves the window on to `time`: adds a keyframe if the car has moved far enough since the last one.
  void advance(Time time, const Pose2& odometry_from_vehicle);

  /// The keyframe nearest in time to `time`. The window must not be empty.
  [[nodiscard]] VertexId nearest_keyframe(Time time) const;

  /// Where the vehicle was, in the window's frame, when it measured at `odometry_from_vehicle`, next to
  /// `keyframe`.
  [[nodiscard]] Pose2 window_from_vehicle(VertexId keyframe, const Pose2& odometry_from_vehicle) const;

  VertexId add_feature(const Pose2& window_from_feature, Time measured_at);

  /// Ties a feature to a keyframe. A second measurement by the same sensor from the same keyframe replaces
  /// the first: a standing car learns nothing new by looking again, and the window stays bounded. Returns
  /// whether it was the first.
  bool add_measurement(const Edge& edge, const EdgeOrigin& origin);

  /// Adds a width or smoothing edge unless the two features are one, or are tied like this already.
  void add_tie(const Edge& edge, const EdgeOrigin& origin);

  /// Forgets features that are behind, beyond reach or stale, then keyframes that no measurement holds. A
  /// keyframe that falls out of the middle leaves the composition of its two odometry edges. `renumber(old)`
  /// of the result is the new id of a vertex, or kForgotten.
  static constexpr VertexId kForgotten = 0xffffffff;
  const std::vector<VertexId>& prune(Time now, const Pose2& odometry_from_vehicle);

  void clear();

  [[nodiscard]] bool empty() const { return keyframes_.empty(); }
  [[nodiscard]] std::size_t feature_count() const { return graph_.vertices.size() - keyframes_.size(); }
  [[nodiscard]] std::size_t keyframe_count() const { return keyframes_.size(); }
  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  [[nodiscard]] PoseGraph& graph() { return graph_; }
  [[nodiscard]] const WindowVertex& vertex(VertexId id) const { return vertices_[id]; }
  [[nodiscard]] WindowVertex& vertex(VertexId id) { return vertices_[id]; }
  [[nodiscard]] const EdgeOrigin& origin(std::size_t edge) const { return origins_[edge]; }

 private:
  void forget_features(Time now, const Pose2& vehicle_from_odometry);
  void forget_keyframes();
  void bridge(std::size_t keyframe);
  void compact();
  void append(const Edge& edge, const EdgeOrigin& origin);

  const FusionConfig& config_;
  PoseGraph graph_;
  std::vector<WindowVertex> vertices_;  ///< beside graph_.vertices
  std::vector<EdgeOrigin> origins_;     ///< beside graph_.edges
  std::vector<VertexId> keyframes_;     ///< from old to new
  std::vector<VertexId> renumbered_;    ///< scratch: new id of each vertex, kForgotten for those that go
  std::vector<char> held_;              ///< scratch: whether a keyframe has a measurement
};

}  // namespace lanefuse
