// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/construction_zone.hpp"

namespace lanefuse {
namespace {

constexpr double kTransition = 100;   ///< [m] on which the lanes move aside, and back
constexpr double kNarrowLane = 2.85;  ///< [m] of the lanes for cars alone
constexpr double kTruckLane = 3.25;   ///< [m] of the right lane
constexpr double kBeyondEdge = 0.6;   ///< [m] that the outer line goes beyond the old edge
constexpr double kRailMark = 2.5;     ///< [m] of rail that shines
constexpr double kRailGap = 2.5;      ///< [m]
constexpr double kRailWidth = 0.15;   ///< [m]

/// Where the yellow line of that number lies, from the left.
double yellow_lateral(RoadDraft& draft, int line, bool to_the_left, double station) {
  const int lanes = draft.main_lanes();
  const double all = kNarrowLane * (lanes - 1) + kTruckLane;
  const double left = to_the_left ? draft.line(0).lateral.at(station) + kBeyondEdge
                                  : draft.line(lanes).lateral.at(station) - kBeyondEdge + all;
  return line < lanes ? left - kNarrowLane * line : left - all;
}

void move_line(RoadDraft& draft, int line, Stretch stretch, double lateral) {
  const RoadLine& white = draft.line(line);
  const PaintStyle usual = white.styles.back();
  const double usual_lateral = white.lateral.at(stretch.begin);
  draft.add_ghost({stretch, LateralCourse(usual_lateral), {usual}});
  PaintStyle yellow = usual;
  yellow.marking.colour = MarkingColour::yellow;
  draft.paint(line, stretch.begin, yellow);
  draft.paint(line, stretch.end, usual);
  LateralCourse& course = draft.line(line).lateral;
  course.swing(stretch.begin, stretch.begin + kTransition, lateral);
  course.swing(stretch.end - kTransition, stretch.end, usual_lateral);
}

}  // namespace

void add_construction_zone(RoadDraft& draft, Stretch stretch, Random& random) {
  const bool to_the_left = random.chance(0.5);
  std::vector<double> laterals;
  for (int line = 0; line <= draft.main_lanes(); ++line) {
    laterals.push_back(yellow_lateral(draft, line, to_the_left, stretch.begin));
  }
  for (int line = 0; line <= draft.main_lanes(); ++line) {
    move_line(draft, line, stretch, laterals[static_cast<std::size_t>(line)]);
  }
  for (int lane = 0; lane < draft.main_lanes(); ++lane) draft.lane(lane).centre.reset();
  draft.leave_out_shoulder(stretch);
}

void add_rail_ghosts(RoadDraft& draft, Stretch stretch) {
  const PaintStyle shine{
      stretch.begin, {MarkingType::unknown, MarkingColour::white}, kRailWidth, kRailMark, kRailGap};
  draft.add_ghost({stretch, draft.left_rail(), {shine}});
  draft.add_ghost({stretch, draft.right_rail(), {shine}});
}

}  // namespace lanefuse
