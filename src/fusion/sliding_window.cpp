// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/sliding_window.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fusion/constraints.hpp"

namespace lanefuse {

void SlidingWindow::advance(Time time, const Pose2& odometry_from_vehicle) {
  if (keyframes_.empty()) {
    graph_.vertices.push_back({odometry_from_vehicle, VertexRole::pose, true});
  } else {
    const VertexId last = keyframes_.back();
    const Pose2 step = vertices_[last].odometry_from_vehicle.inverse() * odometry_from_vehicle;
    const double distance = step.position().norm();
    if (distance < config_.keyframe_distance) return;
    const auto current = static_cast<VertexId>(graph_.vertices.size());
    graph_.vertices[last].fixed = false;
    graph_.vertices.push_back({odometry_from_vehicle, VertexRole::pose, true});
    const double seconds = to_seconds(time - vertices_[last].time);
    append({last, current, step, odometry_information(config_.odometry, distance, seconds)}, {});
  }
  keyframes_.push_back(static_cast<VertexId>(graph_.vertices.size() - 1));
  vertices_.push_back({VertexRole::pose, time, odometry_from_vehicle});
}

VertexId SlidingWindow::nearest_keyframe(Time time) const {
  assert(!keyframes_.empty());
  const auto distance = [&](VertexId id) { return std::chrono::abs(vertices_[id].time - time); };
  std::size_t best = keyframes_.size() - 1;
  while (best > 0 && distance(keyframes_[best - 1]) < distance(keyframes_[best])) --best;
  return keyframes_[best];
}

Pose2 SlidingWindow::window_from_vehicle(VertexId keyframe, const Pose2& odometry_from_vehicle) const {
  return graph_.vertices[keyframe].pose *
         (vertices_[keyframe].odometry_from_vehicle.inverse() * odometry_from_vehicle);
}

VertexId SlidingWindow::add_feature(const Pose2& window_from_feature, Time measured_at) {
  graph_.vertices.push_back({window_from_feature, VertexRole::landmark, false});
  vertices_.push_back({VertexRole::landmark, measured_at, {}});
  return static_cast<VertexId>(graph_.vertices.size() - 1);
}

void SlidingWindow::append(const Edge& edge, const EdgeOrigin& origin) {
  graph_.edges.push_back(edge);
  origins_.push_back(origin);
}

bool SlidingWindow::add_measurement(const Edge& edge, const EdgeOrigin& origin) {
  // All that a keyframe measured stands behind the odometry edge that led to it, however late some of it
  // came.
  for (std::size_t i = graph_.edges.size(); i-- > 0;) {
    const Edge& other = graph_.edges[i];
    if (origins_[i].kind == EdgeKind::odometry && other.to == edge.from) break;
    if (origins_[i].kind != EdgeKind::measurement) continue;
    const bool same = other.from == edge.from && other.to == edge.to && origins_[i].source == origin.source &&
                      origins_[i].sensor_id == origin.sensor_id;
    if (!same) continue;
    graph_.edges[i] = edge;
    origins_[i] = origin;
    return false;
  }
  append(edge, origin);
  return true;
}

void SlidingWindow::add_tie(const Edge& edge, const EdgeOrigin& origin) {
  if (edge.from == edge.to) return;
  for (std::size_t i = graph_.edges.size(); i-- > 0;) {
    if (origins_[i].kind != origin.kind) continue;
    const Edge& other = graph_.edges[i];
    const bool same = other.from == edge.from && other.to == edge.to;
    const bool reverse = other.from == edge.to && other.to == edge.from;
    // Smoothing says the same in both directions; a width has a left and a right end.
    if (same || (reverse && origin.kind == EdgeKind::smoothing)) return;
  }
  Edge tie = edge;
  if (origin.kind == EdgeKind::smoothing && config_.switchable) {
    tie.switch_index = static_cast<std::uint32_t>(graph_.switches.size());
    graph_.switches.push_back({config_.switch_prior, 1});
  }
  append(tie, origin);
}

const std::vector<VertexId>& SlidingWindow::prune(Time now, const Pose2& odometry_from_vehicle) {
  renumbered_.assign(graph_.vertices.size(), 0);
  forget_features(now, odometry_from_vehicle.inverse());
  forget_keyframes();
  compact();
  return renumbered_;
}

void SlidingWindow::forget_features(Time now, const Pose2& vehicle_from_odometry) {
  const Duration max_age = from_seconds(config_.drop_age_s);
  for (VertexId id = 0; id < vertices_.size(); ++id) {
    if (vertices_[id].role != VertexRole::landmark) continue;
    const Pose2& pose = graph_.vertices[id].pose;
    const Eigen::Vector2d position = vehicle_from_odometry * pose.position();
    const bool near = position.x() > -config_.drop_behind && position.x() < config_.drop_beyond &&
                      std::abs(position.y()) < config_.drop_lateral && std::isfinite(pose.heading);
    // Written so that a pose that is not a number goes, too.
    if (!near || now - vertices_[id].time > max_age) renumbered_[id] = kForgotten;
  }
}

void SlidingWindow::forget_keyframes() {
  held_.assign(vertices_.size(), 0);
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const Edge& edge = graph_.edges[i];
    if (origins_[i].kind == EdgeKind::measurement && renumbered_[edge.to] != kForgotten) held_[edge.from] = 1;
  }
  // The newest stays: it is the gauge, and the next step starts from it.
  std::vector<VertexId> kept;
  for (std::size_t k = 0; k < keyframes_.size(); ++k) {
    const VertexId id = keyframes_[k];
    if (held_[id] != 0 || k + 1 == keyframes_.size()) {
      kept.push_back(id);
      continue;
    }
    if (!kept.empty()) bridge(k);
    renumbered_[id] = kForgotten;
  }
  keyframes_ = std::move(kept);
}

void SlidingWindow::bridge(std::size_t keyframe) {
  const VertexId gone = keyframes_[keyframe];
  Edge* into = nullptr;
  Edge* out_of = nullptr;
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    if (origins_[i].kind != EdgeKind::odometry) continue;
    if (graph_.edges[i].to == gone) into = &graph_.edges[i];
    if (graph_.edges[i].from == gone) out_of = &graph_.edges[i];
  }
  assert(into && out_of);
  // Cov(a*b) with the first step's heading error swinging the second step's end; in the composed
  // measurement's frame.
  Eigen::Matrix3d first = Eigen::Matrix3d::Identity();
  const Pose2 back = out_of->measurement.inverse();
  first.topLeftCorner<2, 2>() = rotation(back.heading);
  first(0, 2) = back.y;
  first(1, 2) = -back.x;
  const Eigen::Matrix3d covariance =
      first * into->information.inverse() * first.transpose() + out_of->information.inverse();
  out_of->measurement = into->measurement * out_of->measurement;
  out_of->information = covariance.inverse();
  out_of->from = into->from;
  into->to = into->from;  // a loop onto itself: swept away with the keyframe
}

void SlidingWindow::compact() {
  VertexId next = 0;
  for (VertexId id = 0; id < vertices_.size(); ++id) {
    if (renumbered_[id] == kForgotten) continue;
    renumbered_[id] = next;
    graph_.vertices[next] = graph_.vertices[id];
    vertices_[next++] = vertices_[id];
  }
  graph_.vertices.resize(next);
  vertices_.resize(next);
  for (VertexId& keyframe : keyframes_) keyframe = renumbered_[keyframe];

  std::size_t edge_count = 0;
  std::uint32_t switch_count = 0;
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    Edge edge = graph_.edges[i];
    const bool stays =
        edge.from != edge.to && renumbered_[edge.from] != kForgotten && renumbered_[edge.to] != kForgotten;
    if (!stays) continue;
    edge.from = renumbered_[edge.from];
    edge.to = renumbered_[edge.to];
    if (edge.switch_index != kNoSwitch) {
      // Switches stand in the order of their edges, so none is overwritten before it is read.
      graph_.switches[switch_count] = graph_.switches[edge.switch_index];
      edge.switch_index = switch_count++;
    }
    graph_.edges[edge_count] = edge;
    origins_[edge_count++] = origins_[i];
  }
  graph_.edges.resize(edge_count);
  origins_.resize(edge_count);
  graph_.switches.resize(switch_count);
}

void SlidingWindow::clear() {
  graph_ = {};
  vertices_.clear();
  origins_.clear();
  keyframes_.clear();
}

}  // namespace lanefuse
