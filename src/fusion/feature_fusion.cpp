// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/feature_fusion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "fusion/clothoid_sampling.hpp"
#include "fusion/constraints.hpp"

namespace lanefuse {
namespace {

/// How far beyond its ends the dead reckoning may be stretched to a measurement's stamp.
constexpr Duration kReach = std::chrono::milliseconds(100);

constexpr double kFarthest = 1000;  ///< [m] no sensor of a car reaches so far

/// One number that is none, or a covariance that is not positive definite, would keep the whole window from
/// being solved for as long as it is in there.
bool is_possible(const Feature& feature) {
  return std::abs(feature.x) < kFarthest && std::abs(feature.y) < kFarthest &&
         std::isfinite(feature.heading) && feature.confidence >= 0 && feature.confidence <= 1 &&
         feature.covariance.allFinite() && feature.covariance.llt().info() == Eigen::Success;
}

bool is_possible(const ClothoidMeasurement& measurement) {
  return std::isfinite(measurement.range_begin) && std::isfinite(measurement.range_end);
}

Pose2 pose_of(const Feature& feature) { return {feature.x, feature.y, feature.heading}; }

}  // namespace

/// Where a set's features are tied to the window: the keyframe nearest to their stamp, and the way from
/// there.
struct FeatureFusion::Attachment {
  const FeatureSet& set;
  VertexId keyframe;
  Pose2 keyframe_from_vehicle;        ///< the vehicle at the set's stamp
  Pose2 current_vehicle_from_window;  ///< to the frame of this cycle, in which association works
};

FeatureFusion::FeatureFusion(const FusionConfig& config, std::unique_ptr<GraphSolver> solver)
    : config_(config), solver_(std::move(solver)), window_(config_), association_(config_.association) {}

FusionResult FeatureFusion::process(const Cycle& cycle, const LaneEstimator::StageListener& stage_done) {
  FusionResult result;
  result.has_motion =
      !cycle.motion.empty() && pose_at(cycle.motion, cycle.time, kReach, odometry_from_vehicle_);
  if (!result.has_motion) return result;

  window_.advance(cycle.time, odometry_from_vehicle_);
  renumber_tracks(window_.prune(cycle.time, odometry_from_vehicle_));

  association_.clear();
  const Pose2 vehicle_from_window = odometry_from_vehicle_.inverse();
  const auto& vertices = window_.graph().vertices;
  for (VertexId id = 0; id < vertices.size(); ++id) {
    if (vertices[id].role == VertexRole::landmark)
      association_.add(id, vehicle_from_window * vertices[id].pose);
  }
  for (const FeatureSet& set : cycle.features) add_set(set, cycle, result.features);
  stage_done(Stage::association);

  if (window_listener_) window_listener_(window_.graph());
  result.solve = solver_->solve(window_.graph(), config_.solver);
  read_out();
  stage_done(Stage::solve);
  return result;
}

void FeatureFusion::add_set(const FeatureSet& set, const Cycle& cycle, InputAccounting& accounting) {
  sampled_ = set.features;
  for (const ClothoidMeasurement& clothoid : set.clothoids) {
    if (is_possible(clothoid)) {
      sample_within_reach(clothoid);
    } else {
      ++accounting.rejected;
    }
  }

  Pose2 odometry_from_measured;
  if (!pose_at(cycle.motion, set.measured_at, kReach, odometry_from_measured)) {
    accounting.dropped += sampled_.size();
    return;
  }
  const VertexId keyframe = window_.nearest_keyframe(set.measured_at);
  const Pose2 keyframe_from_odometry = window_.vertex(keyframe).odometry_from_vehicle.inverse();
  const Attachment at{set, keyframe, keyframe_from_odometry * odometry_from_measured,
                      odometry_from_vehicle_.inverse()};
  association_.begin_set();
  vertex_of_.clear();
  for (const Feature& feature : sampled_) {
    const bool possible = is_possible(feature);
    vertex_of_.push_back(possible ? add_feature(feature, at) : SlidingWindow::kForgotten);
    const bool used = vertex_of_.back() != SlidingWindow::kForgotten;
    ++(used ? accounting.used : possible ? accounting.dropped : accounting.rejected);
  }
  tie(set);
}

void FeatureFusion::sample_within_reach(ClothoidMeasurement clothoid) {
  // Also bounds how many samples a wild range can bring.
  clothoid.range_begin = std::max(clothoid.range_begin, -config_.drop_behind);
  clothoid.range_end = std::min(clothoid.range_end, config_.drop_beyond);
  sample_clothoid(clothoid, config_.sample_spacing, sampled_);
}

VertexId FeatureFusion::add_feature(const Feature& feature, const Attachment& at) {
  const Pose2 measurement = at.keyframe_from_vehicle * pose_of(feature);
  const Eigen::Matrix3d information = measurement_information(feature, config_.sigma_along);
  const Pose2 window_from_feature = window_.graph().vertices[at.keyframe].pose * measurement;
  const Pose2 in_vehicle = at.current_vehicle_from_window * window_from_feature;
  const std::optional<VertexId> known = association_.claim(in_vehicle, information);
  if (!known && window_.feature_count() >= config_.max_features) return SlidingWindow::kForgotten;
  const VertexId vertex = known ? *known : window_.add_feature(window_from_feature, at.set.measured_at);
  if (!known) association_.add_claimed(vertex, in_vehicle);
  const bool is_first_look = window_.add_measurement(
      {at.keyframe, vertex, measurement, information},
      {EdgeKind::measurement, at.set.source, at.set.sensor_id, feature.track_id, feature.side});
  if (is_first_look) raise_confidence(vertex, feature, at.set.source);
  remember(vertex, feature, at);
  return vertex;
}

void FeatureFusion::raise_confidence(VertexId id, const Feature& feature, Source source) {
  WindowVertex& vertex = window_.vertex(id);
  // c <- 1 - (1 - c)(1 - g c_m): every witness leaves less doubt. A second look from the same place is none:
  // the slower a car, the surer it would be of whatever misled it.
  vertex.confidence = 1 - (1 - vertex.confidence) * (1 - config_.confidence_gain * feature.confidence);
  auto& hits = vertex.hits[static_cast<std::size_t>(source)];
  if (hits < 0xffff) ++hits;
}

void FeatureFusion::remember(VertexId id, const Feature& feature, const Attachment& at) {
  WindowVertex& vertex = window_.vertex(id);
  vertex.time = std::max(vertex.time, at.set.measured_at);
  if (feature.track_id != kNoTrack) {
    vertex.track_id = feature.track_id;
    vertex.side = feature.side;
  }
  if (feature.marking.type != MarkingType::unknown) vertex.marking.type = feature.marking.type;
  if (feature.marking.colour != MarkingColour::unknown) vertex.marking.colour = feature.marking.colour;
}

void FeatureFusion::tie(const FeatureSet& set) {
  for (std::size_t i = 0; i < sampled_.size(); ++i) {
    if (sampled_[i].track_id == kNoTrack || vertex_of_[i] == SlidingWindow::kForgotten) continue;
    if (config_.smoothing_edges) smooth(sampled_[i], vertex_of_[i]);
    if (!config_.width_edges || !set.lane_width || sampled_[i].side != Side::right) continue;
    for (std::size_t j = 0; j < sampled_.size(); ++j) {
      const bool partner = sampled_[j].track_id == sampled_[i].track_id && sampled_[j].side == Side::left &&
                           vertex_of_[j] != SlidingWindow::kForgotten;
      if (!partner) continue;
      window_.add_tie({vertex_of_[i], vertex_of_[j], width_target(*set.lane_width),
                       width_information(*set.lane_width, config_)},
                      {EdgeKind::width, set.source, set.sensor_id, sampled_[i].track_id, Side::none});
    }
  }
}

void FeatureFusion::smooth(const Feature& feature, VertexId vertex) {
  if (feature.changing_lane) {
    last_of_track_.erase({feature.track_id, feature.side});
    return;
  }
  const auto [entry, is_new] = last_of_track_.try_emplace({feature.track_id, feature.side}, vertex);
  const VertexId previous = std::exchange(entry->second, vertex);
  if (is_new || previous == vertex) return;
  // The paper's target is 0 [eq. 9]: along the road nothing is said, and one cycle's turn of the road is far
  // below the heading's sigma.
  window_.add_tie({previous, vertex, Pose2{}, smoothing_information(config_)},
                  {EdgeKind::smoothing, feature.source, 0, feature.track_id, feature.side});
}

void FeatureFusion::renumber_tracks(const std::vector<VertexId>& new_ids) {
  for (auto& [track, vertex] : last_of_track_) vertex = new_ids[vertex];
  std::erase_if(last_of_track_, [](const auto& entry) { return entry.second == SlidingWindow::kForgotten; });
}

void FeatureFusion::read_out() {
  const auto& graph = window_.graph();
  const Pose2 vehicle_from_window = odometry_from_vehicle_.inverse();
  information_.assign(graph.vertices.size(), Eigen::Matrix3d::Zero());
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (window_.origin(i).kind == EdgeKind::measurement)
      information_[graph.edges[i].to] += graph.edges[i].information;
  }
  fused_.clear();
  for (VertexId id = 0; id < graph.vertices.size(); ++id) {
    if (graph.vertices[id].role != VertexRole::landmark) continue;
    const WindowVertex& vertex = window_.vertex(id);
    const Pose2 pose = vehicle_from_window * graph.vertices[id].pose;
    Feature feature{pose.x, pose.y, pose.heading, vertex.confidence};
    feature.covariance = rotate_covariance(information_[id].inverse(), pose.heading);
    const auto most = std::max_element(vertex.hits.begin(), vertex.hits.end());
    feature.source = static_cast<Source>(most - vertex.hits.begin());
    feature.marking = vertex.marking;
    feature.track_id = vertex.track_id;
    feature.side = vertex.side;
    fused_.push_back(feature);
  }
}

void FeatureFusion::switch_states(std::vector<SwitchState>& out) const {
  const auto& graph = window_.graph();
  const Pose2 vehicle_from_window = odometry_from_vehicle_.inverse();
  out.clear();
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const EdgeOrigin& origin = window_.origin(i);
    if (origin.kind != EdgeKind::smoothing) continue;
    const Edge& edge = graph.edges[i];
    const double value = edge.switch_index == kNoSwitch ? 1 : graph.switches[edge.switch_index].value;
    out.push_back({origin.track_id, origin.side,
                   vehicle_from_window * graph.vertices[edge.from].pose.position(),
                   vehicle_from_window * graph.vertices[edge.to].pose.position(), value});
  }
}

GraphSize FeatureFusion::size() const {
  return {static_cast<std::uint32_t>(window_.keyframe_count()),
          static_cast<std::uint32_t>(window_.feature_count()),
          static_cast<std::uint32_t>(window_.graph().edges.size())};
}

void FeatureFusion::reset() {
  window_.clear();
  last_of_track_.clear();
  fused_.clear();
}

}  // namespace lanefuse
