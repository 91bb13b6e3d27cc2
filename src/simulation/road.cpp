// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/road_course.hpp"

namespace lanefuse {

const char* to_string(RoadKind kind) { return kind == RoadKind::gentle ? "gentle" : "curved"; }

Road::Road(RoadKind kind, double length, const RoadPreset& preset, std::uint64_t seed)
    : Road(kind, length, preset, Random(seed, "road"), Random(seed, "road height")) {}

Road::Road(RoadKind kind, double length, const RoadPreset& preset, Random shape, Random heights)
    : preset_(preset),
      reference_(draw_road_course(kind == RoadKind::gentle ? preset.gentle_radius : preset.curved_radius,
                                  length, shape)),
      height_(preset, reference_.length(), heights),
      lane_width_(shape.uniform(preset.lane_width.low, preset.lane_width.high)) {
  const double period = preset.dash_mark + preset.dash_gap;
  for (int i = 0; i < boundary_count(); ++i) dash_phases_.push_back(shape.uniform(0, period));
}

double Road::boundary_lateral(int boundary) const { return lane_width_ * (preset_.lanes / 2.0 - boundary); }

double Road::lane_centre(int lane) const { return boundary_lateral(lane) - lane_width_ / 2; }

int Road::lane_at(double lateral) const {
  const int lane = static_cast<int>(std::floor(preset_.lanes / 2.0 - lateral / lane_width_));
  return std::clamp(lane, 0, preset_.lanes - 1);
}

MarkingEvidence Road::marking(int boundary) const {
  return {is_edge(boundary) ? MarkingType::solid : MarkingType::dashed, MarkingColour::white};
}

double Road::marking_width(int boundary) const {
  return is_edge(boundary) ? preset_.edge_marking_width : preset_.dashed_marking_width;
}

bool Road::painted(int boundary, double station) const {
  if (is_edge(boundary)) return true;
  const double period = preset_.dash_mark + preset_.dash_gap;
  const double turns = (station + dash_phases_[static_cast<std::size_t>(boundary)]) / period;
  return (turns - std::floor(turns)) * period < preset_.dash_mark;
}

double Road::guard_rail(int side) const {
  return side * (lane_width_ * preset_.lanes / 2.0 + preset_.shoulder + preset_.guard_rail);
}

Pose2 Road::pose(double station, double lateral) const {
  return reference_.pose(station) * Pose2{0, lateral, 0};
}

double Road::curvature(double station, double lateral) const {
  const double curvature = reference_.curvature(station);
  return curvature / (1 - curvature * lateral);
}

TrueRoad true_road(const Road& road) {
  TrueRoad truth;
  for (int i = 0; i < road.boundary_count(); ++i) {
    TrueBoundary boundary{static_cast<std::uint64_t>(i) + 1, road.marking(i), road.marking_width(i), {}};
    for (double station = 0; station <= road.reference().length(); ++station) {
      boundary.points.push_back(road.pose(station, road.boundary_lateral(i)).position());
    }
    truth.boundaries.push_back(std::move(boundary));
  }
  for (int i = 0; i < road.lane_count(); ++i) {
    const auto id = static_cast<std::uint64_t>(i) + 1;
    TrueLane lane{id, id, id + 1, {}, {}};
    if (i > 0) lane.left_lane = id - 1;
    if (i + 1 < road.lane_count()) lane.right_lane = id + 1;
    truth.lanes.push_back(lane);
  }
  return truth;
}

}  // namespace lanefuse
