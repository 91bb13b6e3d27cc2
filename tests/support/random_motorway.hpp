// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <rapidcheck.h>

#include "roadmap/opendrive.hpp"
#include "roadmap/plan_view.hpp"
#include "roadmap/road_map.hpp"

namespace lanefuse::testing {

/// A motorway along a clothoid with an entry lane, of any curvature, width and direction, and its exact
/// course.
struct RandomMotorway {
  RoadMap map;
  ExactPlan plan;
};

inline double any_between(double from, double to) {
  return from + (to - from) * *rc::gen::inRange(0, 10'001) / 10'000.0;
}

inline MapBoundary line_beside(const PlanView& plan, double offset, double from, double to, double slope) {
  MapBoundary line;
  const int steps = static_cast<int>(std::ceil((to - from) / 2));
  for (int i = 0; i <= steps; ++i) {
    const double station = from + (to - from) * i / steps;
    const Eigen::Vector2d at = plan.pose(station) * Eigen::Vector2d(0, offset);
    line.points.emplace_back(at.x(), at.y(), slope * station);
  }
  return line;
}

inline std::vector<MarkingStyle> any_styles(double length) {
  const auto style = [](double from) {
    const auto type = *rc::gen::element(MarkingType::solid, MarkingType::dashed, MarkingType::road_edge,
                                        MarkingType::guard_rail, MarkingType::unknown);
    const bool is_paint = type == MarkingType::solid || type == MarkingType::dashed;
    const auto colour = *rc::gen::element(MarkingColour::white, MarkingColour::yellow);
    return MarkingStyle{from, {type, is_paint ? colour : MarkingColour::unknown}, is_paint ? 0.3 : 0.0};
  };
  std::vector<MarkingStyle> styles = {style(0)};
  if (*rc::gen::arbitrary<bool>()) styles.push_back(style(any_between(0.2, 0.8) * length));
  if (styles.size() == 2 && styles[0].marking == styles[1].marking) styles.pop_back();
  return styles;
}

inline RandomMotorway any_motorway() {
  RandomMotorway made;
  const double length = any_between(120, 400);
  made.plan.start = {any_between(-500, 500), any_between(-500, 500), any_between(-3, 3)};
  made.plan.pieces = {{length, any_between(-0.002, 0.002), any_between(-1e-5, 1e-5)}};
  const PlanView plan({{0, made.plan.start, length,
                        ClothoidPiece{made.plan.pieces[0].curvature, made.plan.pieces[0].curvature_rate}}});
  const double slope = any_between(-0.05, 0.05);
  const int lanes = *rc::gen::inRange(1, 5);
  RoadMap& map = made.map;
  map.name = "any";
  map.origin = GeoOrigin{any_between(-60, 60), any_between(-180, 180), any_between(0, 800)};
  double offset = 0;
  for (int i = 0; i <= lanes; ++i) {
    map.boundaries.push_back(line_beside(plan, offset, 0, length, slope));
    offset -= any_between(3, 4);
  }
  for (int i = 1; i <= lanes; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    MapLane lane{id, LaneKind::driving, id, id + 1, {}, {}, {}};
    if (i > 1) lane.left_lane = id - 1;
    if (i < lanes) lane.right_lane = id + 1;
    map.lanes.push_back(lane);
  }
  const auto last = static_cast<std::uint64_t>(lanes);
  map.lanes.back().right_lane = last + 1;
  const double from = any_between(0.1, 0.4) * length;
  map.boundaries.push_back(line_beside(plan, offset, from, any_between(0.6, 0.9) * length, slope));
  map.lanes.push_back({last + 1, LaneKind::entry, last + 1, last + 2, last, {}, {}});
  for (std::size_t i = 0; i < map.boundaries.size(); ++i) {
    map.boundaries[i].id = i + 1;
    map.boundaries[i].styles = any_styles(length / (i == map.boundaries.size() - 1 ? 4 : 1));
  }
  return made;
}

}  // namespace lanefuse::testing
