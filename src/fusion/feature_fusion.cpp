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

Eigen::Matrix3d covariance_of(const PlanarInformation& information) {
  const double determinant = information.xx * information.yy - information.xy * information.xy;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance(0, 0) = information.yy / determinant;
  covariance(0, 1) = covariance(1, 0) = -information.xy / determinant;
  covariance(1, 1) = information.xx / determinant;
  covariance(2, 2) = 1 / information.heading;
  return covariance;
}

}  // namespace

/// Where a set's features are tied to the window: the keyframe nearest to their stamp, and the way from
/// there.
struct FeatureFusion::Attachment {
  const FeatureSet& set;
  Id keyframe;
  Pose2 keyframe_from_vehicle;        ///< the vehicle at the set's stamp
  Pose2 current_vehicle_from_window;  ///< to the frame of this cycle, in which association works
};

FeatureFusion::FeatureFusion(const FusionConfig& config, std::unique_ptr<WindowSolver> solver)
    : config_(config),
      solver_(std::move(solver)),
      window_(config_),
      association_(config_.association, config_.max_features) {
  fused_.reserve(config_.max_features);
}

FusionResult FeatureFusion::process(const Cycle& cycle, const LaneEstimator::StageListener& stage_done) {
  FusionResult result;
  result.has_motion =
      !cycle.motion.empty() && pose_at(cycle.motion, cycle.time, kReach, odometry_from_vehicle_);
  if (!result.has_motion) return result;

  window_.advance(cycle.time, odometry_from_vehicle_);
  window_.prune(cycle.time, odometry_from_vehicle_);
  forget_tracks(cycle.time);

  association_.clear();
  const Pose2 vehicle_from_window = odometry_from_vehicle_.inverse();
  const WindowGraph& graph = window_.graph();
  for (Id id = 0; id < graph.landmark_slots(); ++id) {
    if (graph.is_alive(id)) association_.add(id, vehicle_from_window * graph.landmark(id));
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
  const Id keyframe = window_.nearest_keyframe(set.measured_at);
  const Pose2 keyframe_from_odometry = window_.keyframe(keyframe).odometry_from_vehicle.inverse();
  const Attachment at{set, keyframe, keyframe_from_odometry * odometry_from_measured,
                      odometry_from_vehicle_.inverse()};
  association_.begin_set();
  fused_of_.clear();
  for (const Feature& feature : sampled_) {
    const bool possible = is_possible(feature);
    fused_of_.push_back(possible ? add_feature(feature, at) : WindowGraph::kNone);
    const bool used = fused_of_.back() != WindowGraph::kNone;
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

FeatureFusion::Id FeatureFusion::add_feature(const Feature& feature, const Attachment& at) {
  if (window_.is_full_of_measurements()) return WindowGraph::kNone;
  const Pose2 measurement = at.keyframe_from_vehicle * pose_of(feature);
  const Eigen::Matrix3d information = measurement_information(feature, config_.sigma_along);
  const Pose2 window_from_feature = window_.graph().pose(at.keyframe) * measurement;
  const Pose2 in_vehicle = at.current_vehicle_from_window * window_from_feature;
  std::optional<Id> fused = association_.claim(in_vehicle, information);
  if (!fused) {
    fused = window_.add_feature(window_from_feature, at.set.measured_at);
    if (!fused) return WindowGraph::kNone;
    association_.add_claimed(*fused, in_vehicle);
  }
  const PlanarInformation own{information(0, 0), information(0, 1), information(1, 1), information(2, 2)};
  const bool is_first_look =
      window_.add_measurement(at.keyframe, *fused, measurement, own, {at.set.source, at.set.sensor_id});
  if (is_first_look) raise_confidence(*fused, feature, at.set.source);
  remember(*fused, feature, at);
  return *fused;
}

void FeatureFusion::raise_confidence(Id id, const Feature& feature, Source source) {
  WindowFeature& fused = window_.feature(id);
  // c <- 1 - (1 - c)(1 - g c_m): every witness leaves less doubt. A second look from the same place is none:
  // the slower a car, the surer it would be of whatever misled it.
  fused.confidence = 1 - (1 - fused.confidence) * (1 - config_.confidence_gain * feature.confidence);
  auto& hits = fused.hits[static_cast<std::size_t>(source)];
  if (hits < 0xffff) ++hits;
}

void FeatureFusion::remember(Id id, const Feature& feature, const Attachment& at) {
  WindowFeature& fused = window_.feature(id);
  fused.time = std::max(fused.time, at.set.measured_at);
  if (feature.track_id != kNoTrack) {
    fused.track_id = feature.track_id;
    fused.side = feature.side;
  }
  if (feature.marking.type != MarkingType::unknown) fused.marking.type = feature.marking.type;
  if (feature.marking.colour != MarkingColour::unknown) fused.marking.colour = feature.marking.colour;
}

void FeatureFusion::tie(const FeatureSet& set) {
  for (std::size_t i = 0; i < sampled_.size(); ++i) {
    if (sampled_[i].track_id == kNoTrack || fused_of_[i] == WindowGraph::kNone) continue;
    if (config_.smoothing_edges) smooth(sampled_[i], fused_of_[i], set.measured_at);
    if (!config_.width_edges || !set.lane_width || sampled_[i].side != Side::right) continue;
    for (std::size_t j = 0; j < sampled_.size(); ++j) {
      const bool partner = sampled_[j].track_id == sampled_[i].track_id && sampled_[j].side == Side::left &&
                           fused_of_[j] != WindowGraph::kNone;
      if (!partner) continue;
      window_.add_tie(TieKind::width,
                      {fused_of_[i], fused_of_[j], width_target(*set.lane_width),
                       width_information(*set.lane_width, config_)},
                      {sampled_[i].track_id, Side::none});
    }
  }
}

void FeatureFusion::smooth(const Feature& feature, Id fused, Time measured_at) {
  const auto end = std::find_if(track_ends_.begin(), track_ends_.end(), [&](const TrackEnd& e) {
    return e.track_id == feature.track_id && e.side == feature.side;
  });
  if (feature.changing_lane) {
    if (end != track_ends_.end()) track_ends_.erase(end);
    return;
  }
  if (end == track_ends_.end()) {
    track_ends_.push_back({feature.track_id, feature.side, fused, measured_at});
    return;
  }
  end->time = measured_at;
  const Id previous = std::exchange(end->feature, fused);
  if (previous == fused) return;
  // The paper's target is 0 [eq. 9]: along the road nothing is said, and one cycle's turn of the road is far
  // below the heading's sigma.
  window_.add_tie(TieKind::smoothing, {previous, fused, Pose2{}, smoothing_information(config_)},
                  {feature.track_id, feature.side});
}

/// Also those that have not been seen for as long as a feature would be remembered: beside a car that stands,
/// features live on and many pass by.
void FeatureFusion::forget_tracks(Time now) {
  const Duration most = from_seconds(config_.drop_age_s);
  std::erase_if(track_ends_, [&](const TrackEnd& end) {
    return !window_.graph().is_alive(end.feature) || now - end.time > most;
  });
}

void FeatureFusion::read_out() {
  const WindowGraph& graph = window_.graph();
  const Pose2 vehicle_from_window = odometry_from_vehicle_.inverse();
  fused_.clear();
  for (Id id = 0; id < graph.landmark_slots(); ++id) {
    if (!graph.is_alive(id)) continue;
    const WindowFeature& known = window_.feature(id);
    const Pose2 pose = vehicle_from_window * graph.landmark(id);
    Feature feature{pose.x, pose.y, pose.heading, known.confidence};
    feature.covariance = rotate_covariance(covariance_of(graph.observed_information(id)), pose.heading);
    const auto most = std::max_element(known.hits.begin(), known.hits.end());
    feature.source = static_cast<Source>(most - known.hits.begin());
    feature.marking = known.marking;
    feature.track_id = known.track_id;
    feature.side = known.side;
    fused_.push_back(feature);
  }
}

void FeatureFusion::switch_states(std::vector<SwitchState>& out) const {
  const WindowGraph& graph = window_.graph();
  const Pose2 vehicle_from_window = odometry_from_vehicle_.inverse();
  out.clear();
  for (Id id = 0; id < graph.tie_slots(); ++id) {
    if (!graph.is_tie(id)) continue;
    const WindowGraph::Tie& tie = graph.tie(id);
    if (tie.kind != static_cast<std::uint32_t>(TieKind::smoothing)) continue;
    const TieOrigin& origin = window_.origin(id);
    out.push_back({origin.track_id, origin.side, vehicle_from_window * graph.landmark(tie.from).position(),
                   vehicle_from_window * graph.landmark(tie.to).position(), tie.switch_value});
  }
}

GraphSize FeatureFusion::size() const {
  return {static_cast<std::uint32_t>(window_.keyframe_count()),
          static_cast<std::uint32_t>(window_.feature_count()),
          static_cast<std::uint32_t>(window_.edge_count())};
}

void FeatureFusion::reset() {
  window_.clear();
  track_ends_.clear();
  fused_.clear();
}

}  // namespace lanefuse
