// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "simulation/generated_road.hpp"

namespace lanefuse {
namespace {

const PaintStyle& style_at(const RoadLine& line, double station) {
  const auto after = std::upper_bound(line.styles.begin() + 1, line.styles.end(), station,
                                      [](double s, const PaintStyle& style) { return s < style.from; });
  return *(after - 1);
}

bool in_dash(const PaintStyle& style, double station) {
  if (style.gap <= 0) return true;
  const double period = style.mark + style.gap;
  const double turns = (station + style.phase) / period;
  return (turns - std::floor(turns)) * period < style.mark;
}

bool paint_is_missing(const RoadLine& line, double station) {
  const auto after = std::upper_bound(line.unpainted.begin(), line.unpainted.end(), station,
                                      [](double s, const Stretch& stretch) { return s < stretch.begin; });
  return after != line.unpainted.begin() && (after - 1)->holds(station);
}

}  // namespace

const char* to_string(RoadKind kind) {
  switch (kind) {
    case RoadKind::gentle:
      return "gentle";
    case RoadKind::curved:
      return "curved";
    case RoadKind::sharp:
      return "sharp";
  }
  return "?";
}

Road::Road(RoadKind kind, double length, const RoadPreset& preset, std::uint64_t seed)
    : Road(generated_road({kind, length}, preset, seed)) {}

Road::Road(ReferenceLine reference, RoadHeight height, RoadParts parts)
    : reference_(std::move(reference)), height_(std::move(height)), parts_(std::move(parts)) {}

const RoadLine& Road::line_at_index(int line) const {
  assert(line >= 0 && line < line_count());
  return parts_.lines[static_cast<std::size_t>(line)];
}

const RoadLane& Road::lane_at_index(int lane) const {
  assert(lane >= 0 && lane < lane_count());
  return parts_.lanes[static_cast<std::size_t>(lane)];
}

bool Road::line_exists(int line, double station) const { return line_at_index(line).stretch.holds(station); }

bool Road::line_runs_within(int line, const Stretch& stretch) const {
  const Stretch& own = line_at_index(line).stretch;
  return own.begin < stretch.end && stretch.begin < own.end;
}

double Road::line_lateral(int line, double station) const { return line_at_index(line).lateral.at(station); }

double Road::line_slope(int line, double station) const { return line_at_index(line).lateral.slope(station); }

MarkingEvidence Road::marking(int line, double station) const {
  return style_at(line_at_index(line), station).marking;
}

double Road::marking_width(int line, double station) const {
  return style_at(line_at_index(line), station).width;
}

bool Road::painted(int line, double station) const {
  const RoadLine& painted = line_at_index(line);
  return painted.stretch.holds(station) && in_dash(style_at(painted, station), station) &&
         !paint_is_missing(painted, station);
}

LineLabel Road::line_label(int line) const { return line_at_index(line).ghost ? kNoLine : line; }

double Road::lane_begin(int lane) const {
  return std::max(line_at_index(left_line(lane)).stretch.begin,
                  line_at_index(right_line(lane)).stretch.begin);
}

double Road::lane_end(int lane) const {
  return std::min(line_at_index(left_line(lane)).stretch.end, line_at_index(right_line(lane)).stretch.end);
}

bool Road::lane_exists(int lane, double station) const {
  return lane_begin(lane) <= station && station < lane_end(lane);
}

double Road::lane_centre(int lane, double station) const {
  const RoadLane& strip = lane_at_index(lane);
  if (strip.centre) return strip.centre->at(station);
  return (line_lateral(strip.left_line, station) + line_lateral(strip.right_line, station)) / 2;
}

double Road::lane_centre_slope(int lane, double station) const {
  const RoadLane& strip = lane_at_index(lane);
  if (strip.centre) return strip.centre->slope(station);
  return (line_slope(strip.left_line, station) + line_slope(strip.right_line, station)) / 2;
}

double Road::lane_width(int lane, double station) const {
  return line_lateral(left_line(lane), station) - line_lateral(right_line(lane), station);
}

std::optional<int> Road::lane_at(double station, double lateral) const {
  for (int lane = 0; lane < lane_count(); ++lane) {
    if (lane_exists(lane, station) && lateral <= line_lateral(left_line(lane), station) &&
        lateral > line_lateral(right_line(lane), station)) {
      return lane;
    }
  }
  return {};
}

std::optional<int> Road::lane_around(double station, double lateral, double reach) const {
  const std::optional<int> lane = lane_at(station, lateral);
  if (!lane) return {};
  const double middle =
      (line_lateral(left_line(*lane), station) + line_lateral(right_line(*lane), station)) / 2;
  return std::abs(lateral - middle) <= reach ? lane : std::nullopt;
}

std::optional<int> Road::neighbour(int lane, Side side, double station) const {
  assert(side != Side::none);
  for (int other = 0; other < lane_count(); ++other) {
    const bool beside =
        side == Side::left ? right_line(other) == left_line(lane) : left_line(other) == right_line(lane);
    if (beside && lane_exists(other, station) && lane_width(other, station) >= kDrivableWidth) return other;
  }
  return {};
}

double Road::guard_rail(int side, double station) const {
  return (side > 0 ? parts_.left_rail : parts_.right_rail).at(station);
}

Pose2 Road::pose(double station, double lateral) const {
  return reference_.pose(station) * Pose2{0, lateral, 0};
}

double Road::curvature(double station, double lateral) const {
  const double curvature = reference_.curvature(station);
  return curvature / (1 - curvature * lateral);
}

}  // namespace lanefuse
