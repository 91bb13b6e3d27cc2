// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "roadmap/road_map.hpp"
#include "simulation/lateral_course.hpp"

namespace lanefuse {

/// What lies on a road, as plain data: lines, lanes and guard rails along the reference line. Places along it
/// are stations [m], places across it lateral offsets [m], positive to the left.

/// A piece of the road's length.
struct Stretch {
  double begin = 0;  ///< [m]
  double end = 0;    ///< [m], not part of it
  [[nodiscard]] bool holds(double station) const { return begin <= station && station < end; }
  friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// How a line is painted from one station on, until the next style begins.
struct PaintStyle {
  double from = 0;  ///< [m] of the station
  MarkingEvidence marking;
  double width = 0.15;  ///< [m] of the paint
  double mark = 0;      ///< [m] of a dash
  double gap = 0;       ///< [m] between dashes; 0: there are none
  double phase = 0;     ///< [m] by which the dashes are moved back
};

/// A painted line.
struct RoadLine {
  Stretch stretch;
  LateralCourse lateral{0};
  std::vector<PaintStyle> styles;  ///< in order, at least one; the first holds from the line's beginning
  std::vector<Stretch> unpainted;  ///< in order: where the paint is worn off or never was
  bool ghost = false;              ///< it bounds no lane: old white under yellow, a seam of tar
};

/// The strip between two lines, as far as both of them run.
struct RoadLane {
  LaneKind kind = LaneKind::driving;
  int left_line = 0;   ///< index into the lines
  int right_line = 0;  ///< index into the lines
  /// Where its vehicles drive; half-way between the lines if it is not said.
  std::optional<LateralCourse> centre;
};

/// A hard shoulder: the strip to the right of a line, out to an edge of its own.
struct HardShoulder {
  int left_line = 0;  ///< index into the lines
  Stretch stretch;
  double width = 2.5;  ///< [m]
};

struct RoadParts {
  std::vector<RoadLine>
      lines;  ///< from left to right, wherever two of them run side by side; ghosts come last
  std::vector<RoadLane> lanes;  ///< from left to right, wherever two of them run side by side
  std::vector<HardShoulder> shoulders;
  LateralCourse left_rail{0};
  LateralCourse right_rail{0};
};

}  // namespace lanefuse
