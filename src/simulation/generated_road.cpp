// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/generated_road.hpp"

#include <utility>

#include "core/random.hpp"
#include "simulation/road_course.hpp"

namespace lanefuse {
namespace {

PaintStyle edge_style(const RoadPreset& preset) {
  return {0, {MarkingType::solid, MarkingColour::white}, preset.edge_marking_width};
}

PaintStyle lane_line_style(const RoadPreset& preset, double phase) {
  return {0,
          {MarkingType::dashed, MarkingColour::white},
          preset.dashed_marking_width,
          preset.dash_mark,
          preset.dash_gap,
          phase};
}

RoadLayout draw_layout(const RoadPreset& preset, double length, Random& random) {
  const double width = random.uniform(preset.lane_width.low, preset.lane_width.high);
  RoadLayout layout;
  for (int i = 0; i <= preset.lanes; ++i) {
    // Drawn for the edges too, though they have no dashes: a draw less, and every drive would change.
    const double phase = random.uniform(0, preset.dash_mark + preset.dash_gap);
    const bool edge = i == 0 || i == preset.lanes;
    layout.lines.push_back({{0, length},
                            LateralCourse(width * (preset.lanes / 2.0 - i)),
                            {edge ? edge_style(preset) : lane_line_style(preset, phase)}});
  }
  for (int i = 0; i < preset.lanes; ++i) {
    const double left = layout.lines[static_cast<std::size_t>(i)].lateral.at(0);
    layout.lanes.push_back({LaneKind::driving, i, i + 1, LateralCourse(left - width / 2)});
  }
  layout.shoulders.push_back({preset.lanes, {0, length}, preset.shoulder});
  const double rail = width * preset.lanes / 2.0 + preset.shoulder + preset.guard_rail;
  layout.left_rail = LateralCourse(rail);
  layout.right_rail = LateralCourse(-rail);
  return layout;
}

}  // namespace

Road generated_road(RoadKind kind, double length, const RoadPreset& preset, std::uint64_t seed) {
  Random shape(seed, "road");
  Random heights(seed, "road height");
  const Range radius = kind == RoadKind::gentle ? preset.gentle_radius : preset.curved_radius;
  ReferenceLine reference(draw_road_course(radius, length, shape));
  RoadHeight height(preset, reference.length(), heights);
  RoadLayout layout = draw_layout(preset, reference.length(), shape);
  return {std::move(reference), std::move(height), std::move(layout)};
}

}  // namespace lanefuse
