// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/ramps.hpp"

namespace lanefuse {
namespace {

constexpr double kRampAside = 16;   ///< [m] that a ramp has gone across the road at its end
constexpr double kBlockMark = 6;    ///< [m] of the broad dashes beside an exit or entry lane
constexpr double kBlockGap = 6;     ///< [m]
constexpr double kLongTaper = 120;  ///< [m] on which a main lane is closed

PaintStyle block_style(const RoadDraft& draft) {
  PaintStyle style = draft.edge_style();
  style.marking.type = MarkingType::dashed;
  style.mark = kBlockMark;
  style.gap = kBlockGap;
  return style;
}

/// Paints the right edge of the main lanes anew on a stretch, and as before behind it.
void paint_edge(RoadDraft& draft, Stretch stretch, const PaintStyle& style) {
  draft.paint(draft.right_edge(), stretch.begin, style);
  draft.paint(draft.right_edge(), stretch.end, draft.edge_style());
}

double edge_lateral(RoadDraft& draft, double station) {
  return draft.line(draft.right_edge()).lateral.at(station);
}

/// The guard rail makes room for a lane, from the opening taper to the closing one.
void move_rail(RoadDraft& draft, Stretch opening, Stretch closing) {
  LateralCourse& rail = draft.right_rail();
  const double usual = rail.at(opening.begin);
  rail.swing(opening.begin, opening.end, usual - draft.lane_width());
  rail.swing(closing.begin, closing.end, usual);
}

}  // namespace

void add_exit(RoadDraft& draft, Stretch stretch) {
  const double nose = stretch.end - kRamp;
  const double near = edge_lateral(draft, stretch.begin);
  const double far = near - draft.lane_width();
  paint_edge(draft, {stretch.begin, nose}, block_style(draft));
  LateralCourse outer(near);
  outer.swing(stretch.begin, stretch.begin + kTaper, far);
  LateralCourse ramp_left(near);
  ramp_left.swing(nose, stretch.end, near - kRampAside);
  LateralCourse ramp_right(far);
  ramp_right.swing(nose, stretch.end, far - kRampAside);
  draft.add_lane(LaneKind::exit, draft.right_edge(), draft.add_edge({stretch.begin, nose}, outer));
  const int left = draft.add_edge({nose, stretch.end}, ramp_left);
  draft.add_lane(LaneKind::exit, left, draft.add_edge({nose, stretch.end}, ramp_right));
  draft.leave_out_shoulder(stretch);
  move_rail(draft, {stretch.begin, stretch.begin + kTaper}, {nose, stretch.end});
}

void add_entry(RoadDraft& draft, Stretch stretch) {
  const double nose = stretch.begin + kRamp;
  const double near = edge_lateral(draft, stretch.begin);
  const double far = near - draft.lane_width();
  paint_edge(draft, {nose, stretch.end}, block_style(draft));
  LateralCourse ramp_left(near - kRampAside);
  ramp_left.swing(stretch.begin, nose, near);
  LateralCourse ramp_right(far - kRampAside);
  ramp_right.swing(stretch.begin, nose, far);
  LateralCourse outer(far);
  outer.swing(stretch.end - kTaper, stretch.end, near);
  const int left = draft.add_edge({stretch.begin, nose}, ramp_left);
  draft.add_lane(LaneKind::entry, left, draft.add_edge({stretch.begin, nose}, ramp_right));
  draft.add_lane(LaneKind::entry, draft.right_edge(), draft.add_edge({nose, stretch.end}, outer));
  draft.leave_out_shoulder(stretch);
  move_rail(draft, {stretch.begin, nose}, {stretch.end - kTaper, stretch.end});
}

void add_ending_lane(RoadDraft& draft, Stretch stretch) {
  const double closing = stretch.end - kLongTaper;
  const double near = edge_lateral(draft, stretch.begin);
  paint_edge(draft, stretch, draft.lane_line_style(0));
  // The lane line ends where the lane is half closed.
  draft.line(draft.right_edge()).unpainted.push_back({closing + kLongTaper / 2, stretch.end});
  LateralCourse outer(near);
  outer.swing(stretch.begin, stretch.begin + kTaper, near - draft.lane_width());
  outer.swing(closing, stretch.end, near);
  const int edge = draft.add_edge(stretch, outer);
  draft.add_lane(LaneKind::driving, draft.right_edge(), edge);
  draft.leave_out_shoulder(stretch);
  draft.add_shoulder(edge, {stretch.begin + kTaper, closing});
  move_rail(draft, {stretch.begin, stretch.begin + kTaper}, {closing, stretch.end});
}

}  // namespace lanefuse
