// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/debug_view_codec.hpp"

#include "lanefuse/debug_view.pb.h"
#include "recording/core_fields.hpp"

namespace lanefuse {
namespace {

/// A window holds the features of many cycles.
constexpr int kMaxWindow = 16 * kMaxFeatures;

void put(const Eigen::Vector2d& point, v1::Point& message) {
  message.set_x(point.x());
  message.set_y(point.y());
}

void put(const SwitchState& state, v1::SwitchState& message) {
  if (state.track_id != kNoTrack) message.set_track_id(state.track_id);
  message.set_side(static_cast<v1::Side>(state.side));
  put(state.from, *message.mutable_from());
  put(state.to, *message.mutable_to());
  message.set_value(state.value);
}

SwitchState take(const v1::SwitchState& message) {
  return {.track_id = message.has_track_id() ? message.track_id() : kNoTrack,
          .side = take_side(message.side()),
          .from = {message.from().x(), message.from().y()},
          .to = {message.to().x(), message.to().y()},
          .value = message.value()};
}

}  // namespace

mcap::Bytes encode_fused_features(const DebugView& view) {
  v1::FusedFeatures message;
  for (const FusedFeature& fused : view.features) {
    v1::FusedFeature& part = *message.add_features();
    lanefuse::put(fused.feature, *part.mutable_feature());
    part.set_in_base_fit(fused.in_base_fit);
    part.set_outlier(fused.outlier);
    part.set_boundary(fused.boundary);
  }
  return to_bytes(message);
}

void decode_fused_features(std::span<const std::byte> bytes, DebugView& view) {
  const auto message = parsed<v1::FusedFeatures>(bytes);
  check_count(message.features_size(), kMaxWindow, message.GetTypeName());
  view.features.clear();
  for (const v1::FusedFeature& part : message.features()) {
    view.features.push_back(
        {lanefuse::take(part.feature()), part.in_base_fit(), part.outlier(), part.boundary()});
  }
}

mcap::Bytes encode_switches(const DebugView& view) {
  v1::SwitchStates message;
  for (const SwitchState& state : view.switches) put(state, *message.add_switches());
  return to_bytes(message);
}

void decode_switches(std::span<const std::byte> bytes, DebugView& view) {
  const auto message = parsed<v1::SwitchStates>(bytes);
  check_count(message.switches_size(), kMaxWindow, message.GetTypeName());
  view.switches.clear();
  for (const v1::SwitchState& part : message.switches()) view.switches.push_back(take(part));
}

mcap::Bytes encode_road_course(const DebugView& view) {
  v1::RoadCourse message;
  if (view.base_clothoid) lanefuse::put(*view.base_clothoid, *message.mutable_base_clothoid());
  message.mutable_graph()->set_poses(view.graph.poses);
  message.mutable_graph()->set_features(view.graph.features);
  message.mutable_graph()->set_edges(view.graph.edges);
  return to_bytes(message);
}

void decode_road_course(std::span<const std::byte> bytes, DebugView& view) {
  const auto message = parsed<v1::RoadCourse>(bytes);
  view.base_clothoid.reset();
  if (message.has_base_clothoid()) view.base_clothoid = lanefuse::take(message.base_clothoid());
  view.graph = {message.graph().poses(), message.graph().features(), message.graph().edges()};
}

}  // namespace lanefuse
