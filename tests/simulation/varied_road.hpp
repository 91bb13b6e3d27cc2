// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/preset.hpp"
#include "simulation/road.hpp"

namespace lanefuse::testing {

/// A gently bent road on which all happens that can happen to a lane: the left one of four ends at 1500 m, an
/// entry lane runs from 2500 m to 2870 m, an exit lane from 3500 m to 3810 m, and from 4200 m to 5000 m the
/// lanes are shifted and narrow.
class VariedRoad {
 public:
  static constexpr int kEndingLane = 0;
  static constexpr int kEntry = 4;
  static constexpr int kExit = 5;
  static constexpr double kEndingLaneEnd = 1500;
  static constexpr double kEntryEnd = 2870;

  static Road make(std::uint64_t seed) {
    RoadPreset preset = nominal_preset().road;
    Random heights(seed, "road height");
    ReferenceLine reference({{2000, 0, 0}, {500, 0, 1e-6}, {3000, 5e-4, 0}, {1500, 5e-4, -1e-6}});
    const double length = reference.length();
    RoadHeight height(preset, length, heights);
    return {std::move(reference), std::move(height), parts(length)};
  }

 private:
  static RoadLine line(Stretch stretch, LateralCourse course) {
    return {stretch, std::move(course), {{0, {MarkingType::dashed, MarkingColour::white}, 0.15, 6, 12}}};
  }

  static RoadParts parts(double length) {
    RoadParts parts;
    const double usual[] = {7.2, 3.6, 0, -3.6, -7.2};
    const double shifted[] = {0, 5.2, 2.4, -0.5, -3.6};
    for (int i = 0; i < 5; ++i) {
      LateralCourse course(usual[i]);
      if (i > 0) {
        course.swing(4200, 4400, shifted[i]);
        course.swing(5000, 5200, usual[i]);
      }
      parts.lines.push_back(line({0, length}, course));
    }
    parts.lines[0].stretch.end = kEndingLaneEnd;
    parts.lines[0].lateral.swing(1440, kEndingLaneEnd, usual[1]);
    parts.lines.push_back(ramp_line(2500, kEntryEnd, true));
    parts.lines.push_back(ramp_line(3500, 3810, false));
    for (int i = 0; i < 4; ++i) parts.lanes.push_back({LaneKind::driving, i, i + 1});
    parts.lanes.push_back({LaneKind::entry, 4, 5});
    parts.lanes.push_back({LaneKind::exit, 4, 6});
    parts.left_rail = LateralCourse(9);
    parts.right_rail = LateralCourse(-14);
    return parts;
  }

  /// The outer line of a lane at the right edge, 60 m to widen and, if it closes again, 60 m to end.
  static RoadLine ramp_line(double begin, double end, bool closes) {
    LateralCourse course(-7.2);
    course.swing(begin, begin + 60, -10.8);
    if (closes) course.swing(end - 60, end, -7.2);
    return line({begin, end}, course);
  }
};

}  // namespace lanefuse::testing
