// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/sliding_window.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "fusion/constraints.hpp"

namespace lanefuse {

namespace {

/// The share of the bounds that is kept free for what the next cycle brings.
constexpr std::size_t kFreeShare = 16;

std::uint64_t packed(const Witness& witness) {
  return (static_cast<std::uint64_t>(witness.source) << 32U) | witness.sensor_id;
}

/// Puts `value` at a slot that may be the next new one.
template <typename T>
void put(std::vector<T>& by_id, WindowGraph::Id id, const T& value) {
  if (id >= by_id.size()) by_id.resize(id + 1);
  by_id[id] = value;
}

WindowGraph::Limits limits(const FusionConfig& config) {
  WindowGraph::Limits limits;
  limits.landmarks = config.max_features;
  limits.observations = config.max_measurements;
  limits.ties = config.max_ties;
  return limits;
}

}  // namespace

SlidingWindow::SlidingWindow(const FusionConfig& config) : config_(config), graph_(limits(config)) {
  const WindowGraph::Limits reserved = limits(config);
  keyframes_.reserve(reserved.poses + 1);  // the graph's first is nowhere
  features_.reserve(reserved.landmarks);
  origins_.reserve(reserved.ties);
  by_information_.reserve(reserved.landmarks);
}

void SlidingWindow::advance(Time time, const Pose2& odometry_from_vehicle) {
  Pose2 step;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  if (!empty()) {
    const Keyframe& last = keyframes_[graph_.chain().back()];
    step = last.odometry_from_vehicle.inverse() * odometry_from_vehicle;
    const double distance = step.position().norm();
    if (distance < config_.keyframe_distance) return;
    information = odometry_information(config_.odometry, distance, to_seconds(time - last.time));
  }
  put(keyframes_, graph_.append_pose(odometry_from_vehicle, step, information),
      {time, odometry_from_vehicle});
}

SlidingWindow::Id SlidingWindow::nearest_keyframe(Time time) const {
  assert(!empty());
  const auto chain = graph_.chain();
  const auto distance = [&](std::size_t k) { return std::chrono::abs(keyframes_[chain[k]].time - time); };
  std::size_t best = chain.size() - 1;
  while (best > 0 && distance(best - 1) < distance(best)) --best;
  return chain[best];
}

Pose2 SlidingWindow::window_from_vehicle(Id keyframe, const Pose2& odometry_from_vehicle) const {
  return graph_.pose(keyframe) *
         (keyframes_[keyframe].odometry_from_vehicle.inverse() * odometry_from_vehicle);
}

std::optional<SlidingWindow::Id> SlidingWindow::add_feature(const Pose2& window_from_feature,
                                                            Time measured_at) {
  if (feature_count() >= config_.max_features || is_full_of_measurements()) return std::nullopt;
  const Id id = graph_.add_landmark(window_from_feature);
  WindowFeature feature;
  feature.time = measured_at;
  put(features_, id, feature);
  return id;
}

bool SlidingWindow::add_measurement(Id keyframe, Id feature, const Pose2& seen,
                                    const PlanarInformation& information, const Witness& witness) {
  return graph_.observe(keyframe, feature, seen, information, packed(witness));
}

void SlidingWindow::add_tie(TieKind kind, const FeatureTie& tie, const TieOrigin& origin) {
  if (graph_.tie_count() >= config_.max_ties) return;
  WindowGraph::Tie edge;
  edge.from = tie.from;
  edge.to = tie.to;
  edge.measurement = tie.measurement;
  edge.kind = static_cast<std::uint32_t>(kind);
  // Smoothing says the same in both directions; a width has a left and a right end.
  const bool symmetric = kind == TieKind::smoothing;
  if (symmetric && config_.switchable) edge.switch_prior = config_.switch_prior;
  const Id id = graph_.add_tie(edge, tie.information, symmetric);
  if (id != WindowGraph::kNone) put(origins_, id, origin);
}

void SlidingWindow::prune(Time now, const Pose2& odometry_from_vehicle) {
  forget_features(now, odometry_from_vehicle.inverse());
  make_room(now);
  forget_keyframes();
}

void SlidingWindow::forget_features(Time now, const Pose2& vehicle_from_odometry) {
  const Duration max_age = from_seconds(config_.drop_age_s);
  const double c = std::cos(vehicle_from_odometry.heading);
  const double s = std::sin(vehicle_from_odometry.heading);
  for (Id id = 0; id < graph_.landmark_slots(); ++id) {
    if (!graph_.is_alive(id)) continue;
    const Pose2 pose = graph_.landmark(id);
    const double x = vehicle_from_odometry.x + c * pose.x - s * pose.y;
    const double y = vehicle_from_odometry.y + s * pose.x + c * pose.y;
    const bool near = x > -config_.drop_behind && x < config_.drop_beyond &&
                      std::abs(y) < config_.drop_lateral && std::isfinite(pose.heading);
    // Written so that a pose that is not a number goes, too.
    if (!near || now - features_[id].time > max_age) graph_.remove_landmark(id);
  }
}

void SlidingWindow::make_room(Time now) {
  const auto fits = [](std::size_t count, std::size_t bound) { return count <= bound - bound / kFreeShare; };
  const auto features_fit = [&] {
    return fits(feature_count(), config_.max_features) &&
           fits(graph_.observation_count(), config_.max_measurements);
  };
  const auto ties_fit = [&] { return fits(graph_.tie_count(), config_.max_ties); };
  if (features_fit() && ties_fit()) return;
  by_information_.clear();
  for (Id id = 0; id < graph_.landmark_slots(); ++id) {
    // What has just been seen for the first time could not have told more yet.
    if (graph_.is_alive(id) && features_[id].time < now)
      by_information_.emplace_back(graph_.observed_information(id).yy, id);
  }
  std::make_heap(by_information_.begin(), by_information_.end(), std::greater<>());
  while (!by_information_.empty() && !(features_fit() && ties_fit())) {
    std::pop_heap(by_information_.begin(), by_information_.end(), std::greater<>());
    const Id id = by_information_.back().second;
    by_information_.pop_back();
    if (features_fit() && graph_.first_tie(id) == WindowGraph::kNone) continue;  // it makes no room for ties
    graph_.remove_landmark(id);
    ++crowded_out_;
  }
}

void SlidingWindow::forget_keyframes() {
  // The newest stays: it is the gauge, and the next step starts from it.
  for (std::size_t k = keyframe_count(); k-- > 0;) {
    if (k + 1 == keyframe_count() || graph_.observations_from(graph_.chain()[k]) != 0) continue;
    graph_.remove_pose(k);
  }
}

std::size_t SlidingWindow::edge_count() const {
  const std::size_t steps = empty() ? 0 : keyframe_count() - 1;
  return steps + graph_.observation_count() + graph_.tie_count();
}

void SlidingWindow::clear() { graph_.clear(); }

}  // namespace lanefuse
