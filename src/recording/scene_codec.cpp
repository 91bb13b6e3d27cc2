// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "foxglove/scene.pb.h"
#include "recording/foxglove_fields.hpp"
#include "recording/message_bytes.hpp"
#include "recording/viewer_codec.hpp"

namespace lanefuse {
namespace {

constexpr Rgba kGrey{0.6, 0.6, 0.6, 0.5};
constexpr Rgba kRed{0.9, 0.1, 0.1, 1};
constexpr Rgba kRoadCourse{0.5, 0.3, 0.8, 0.8};

Rgba colour_of(Source source) {
  switch (source) {
    case Source::serial_camera:
      return {0.12, 0.47, 0.71, 1};
    case Source::high_resolution_camera:
      return {0.17, 0.63, 0.17, 1};
    case Source::objects:
      return {1.0, 0.5, 0.05, 1};
    case Source::ego_path:
      return {0.55, 0.34, 0.29, 1};
    case Source::vehicle_to_vehicle:
      return {0.89, 0.47, 0.76, 1};
    case Source::user:
      return {0.09, 0.75, 0.81, 1};
  }
  return kGrey;
}

Rgba colour_of(const Boundary& boundary) {
  const double alpha = std::clamp(boundary.confidence, 0.2, 1.0);
  if (boundary.marking.colour == MarkingColour::yellow) return {1.0, 0.85, 0.2, alpha};
  return {1, 1, 1, alpha};
}

foxglove::SceneEntity& add_entity(foxglove::SceneUpdate& scene, const char* id, Time time) {
  foxglove::SceneEntity& entity = *scene.add_entities();
  put(time, *entity.mutable_timestamp());
  entity.set_frame_id(kVehicleFrame);
  entity.set_id(id);
  return entity;
}

foxglove::LinePrimitive& add_line(foxglove::SceneEntity& entity, const Rgba& colour, double thickness) {
  foxglove::LinePrimitive& line = *entity.add_lines();
  put_pose(0, 0, 0, *line.mutable_pose());
  line.set_thickness(thickness);
  put(colour, *line.mutable_color());
  return line;
}

/// Whole 1024ths of a metre: finer than any eye, and their empty bits pack to a fraction.
double for_the_eye(double metres) { return std::round(metres * 1024) / 1024; }

void add_point(foxglove::LinePrimitive& line, double x, double y) {
  foxglove::Point3& point = *line.add_points();
  point.set_x(for_the_eye(x));
  point.set_y(for_the_eye(y));
}

void draw_boundaries(const LaneEstimate& estimate, foxglove::SceneEntity& entity) {
  for (const Boundary& boundary : estimate.boundaries) {
    foxglove::LinePrimitive& line = add_line(entity, colour_of(boundary), 0.15);
    for (const BoundaryPoint& point : boundary.points) add_point(line, point.x, point.y);
  }
}

/// A short dash along its heading for each feature; all of one colour are one primitive, as there may be
/// thousands.
void draw_features(const DebugView& view, foxglove::SceneEntity& entity) {
  constexpr std::size_t kOutliers = kSourceCount;
  constexpr double kHalfDash = 0.4;  // [m]
  std::array<foxglove::LinePrimitive*, kSourceCount + 1> lines{};
  for (const FusedFeature& fused : view.features) {
    const Feature& feature = fused.feature;
    const std::size_t kind = fused.outlier ? kOutliers : static_cast<std::size_t>(feature.source);
    if (!lines[kind]) {
      lines[kind] = &add_line(entity, fused.outlier ? kGrey : colour_of(feature.source), 0.2);
      lines[kind]->set_type(foxglove::LinePrimitive::LINE_LIST);
    }
    const double dx = kHalfDash * std::cos(feature.heading);
    const double dy = kHalfDash * std::sin(feature.heading);
    add_point(*lines[kind], feature.x - dx, feature.y - dy);
    add_point(*lines[kind], feature.x + dx, feature.y + dy);
  }
}

void draw_road_course(const LaneEstimate& estimate, const DebugView& view, foxglove::SceneEntity& entity) {
  if (!view.base_clothoid) return;
  double end = 0;
  for (const Boundary& boundary : estimate.boundaries) end = std::max(end, boundary.range_end);
  foxglove::LinePrimitive& line = add_line(entity, kRoadCourse, 0.1);
  const int count = static_cast<int>(std::min(end, 1000.0) / kPointSpacing);
  for (int i = 0; i <= count; ++i)
    add_point(line, i * kPointSpacing, view.base_clothoid->y(i * kPointSpacing));
}

void draw_switches(const DebugView& view, foxglove::SceneEntity& entity) {
  for (const SwitchState& state : view.switches) {
    if (state.value >= 0.5) continue;
    foxglove::LinePrimitive& line = add_line(entity, kRed, 0.1);
    add_point(line, state.from.x(), state.from.y());
    add_point(line, state.to.x(), state.to.y());
  }
}

}  // namespace

mcap::Bytes encode_scene(const LaneEstimate& estimate, const DebugView& view) {
  foxglove::SceneUpdate scene;
  // An entity replaces the one of the same id: every cycle draws all of them anew, even if empty.
  draw_boundaries(estimate, add_entity(scene, "boundaries", estimate.time));
  draw_features(view, add_entity(scene, "fused features", estimate.time));
  draw_road_course(estimate, view, add_entity(scene, "road course", estimate.time));
  draw_switches(view, add_entity(scene, "switched off", estimate.time));
  return to_bytes(scene);
}

}  // namespace lanefuse
