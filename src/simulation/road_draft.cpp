// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_draft.hpp"

#include <algorithm>
#include <utility>

namespace lanefuse {
namespace {

constexpr double kShortestShoulder = 10;  ///< [m] between two events; shorter ones are left out

/// Sorts stretches and joins those that overlap.
void tidy(std::vector<Stretch>& stretches) {
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  std::vector<Stretch> joined;
  for (const Stretch& stretch : stretches) {
    if (!joined.empty() && stretch.begin <= joined.back().end) {
      joined.back().end = std::max(joined.back().end, stretch.end);
    } else {
      joined.push_back(stretch);
    }
  }
  stretches = std::move(joined);
}

}  // namespace

RoadDraft::RoadDraft(const RoadPreset& preset, double length, Random& random)
    : preset_(preset),
      length_(length),
      lane_width_(random.uniform(preset.lane_width.low, preset.lane_width.high)) {
  for (int i = 0; i <= preset.lanes; ++i) {
    // Drawn for the edges too, though they have no dashes: a draw less, and every drive would change.
    const double phase = random.uniform(0, preset.dash_mark + preset.dash_gap);
    const bool edge = i == 0 || i == preset.lanes;
    const double lateral = lane_width_ * (preset.lanes / 2.0 - i);
    parts_.lines.push_back(
        {{0, length}, LateralCourse(lateral), {edge ? edge_style() : lane_line_style(phase)}});
  }
  for (int i = 0; i < preset.lanes; ++i) {
    add_lane(LaneKind::driving, i, i + 1);
    lane(i).centre = LateralCourse(line(i).lateral.at(0) - lane_width_ / 2);
  }
  const double rail = lane_width_ * preset.lanes / 2.0 + preset.shoulder + preset.guard_rail;
  left_rail() = LateralCourse(rail);
  right_rail() = LateralCourse(-rail);
}

PaintStyle RoadDraft::edge_style() const {
  return {0, {MarkingType::solid, MarkingColour::white}, preset_.edge_marking_width};
}

PaintStyle RoadDraft::lane_line_style(double phase) const {
  return {0,
          {MarkingType::dashed, MarkingColour::white},
          preset_.dashed_marking_width,
          preset_.dash_mark,
          preset_.dash_gap,
          phase};
}

int RoadDraft::add_edge(Stretch stretch, LateralCourse lateral) {
  parts_.lines.push_back({stretch, std::move(lateral), {edge_style()}});
  return static_cast<int>(parts_.lines.size()) - 1;
}

void RoadDraft::add_lane(LaneKind kind, int left_line, int right_line) {
  parts_.lanes.push_back({kind, left_line, right_line, {}});
}

void RoadDraft::add_shoulder(int left_line, Stretch stretch) {
  if (stretch.end - stretch.begin < kShortestShoulder) return;
  parts_.shoulders.push_back({left_line, stretch, preset_.shoulder});
}

void RoadDraft::add_ghost(RoadLine line) {
  line.ghost = true;
  ghosts_.push_back(std::move(line));
}

void RoadDraft::paint(int index, double from, PaintStyle style) {
  style.from = from;
  line(index).styles.push_back(style);
}

void RoadDraft::remove_paint(int from_line, Stretch stretch) {
  for (auto i = static_cast<std::size_t>(from_line); i < parts_.lines.size(); ++i) {
    parts_.lines[i].unpainted.push_back(stretch);
  }
}

RoadParts RoadDraft::finished() const {
  RoadDraft draft = *this;
  double begin = 0;
  tidy(draft.without_shoulder_);
  for (const Stretch& none : draft.without_shoulder_) {
    draft.add_shoulder(right_edge(), {begin, none.begin});
    begin = none.end;
  }
  draft.add_shoulder(right_edge(), {begin, length_});
  RoadParts parts = std::move(draft.parts_);
  parts.lines.insert(parts.lines.end(), ghosts_.begin(), ghosts_.end());
  for (RoadLine& line : parts.lines) tidy(line.unpainted);
  return parts;
}

}  // namespace lanefuse
