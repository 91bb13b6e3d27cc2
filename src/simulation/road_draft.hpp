// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/random.hpp"
#include "simulation/preset.hpp"
#include "simulation/road_parts.hpp"

namespace lanefuse {

/// A road's parts while events are laid onto it, in the order of their stations. The first lines and lanes
/// are those that run from end to end.
class RoadDraft {
 public:
  /// Lanes, lines and guard rails of one width from end to end.
  RoadDraft(const RoadPreset& preset, double length, Random& random);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double lane_width() const { return lane_width_; }
  [[nodiscard]] int main_lanes() const { return preset_.lanes; }
  [[nodiscard]] int right_edge() const { return preset_.lanes; }
  [[nodiscard]] double shoulder() const { return preset_.shoulder; }

  [[nodiscard]] RoadLine& line(int index) { return parts_.lines[static_cast<std::size_t>(index)]; }
  [[nodiscard]] RoadLane& lane(int index) { return parts_.lanes[static_cast<std::size_t>(index)]; }
  [[nodiscard]] LateralCourse& left_rail() { return parts_.left_rail; }
  [[nodiscard]] LateralCourse& right_rail() { return parts_.right_rail; }

  /// Adds a solid white line and gives its index.
  int add_edge(Stretch stretch, LateralCourse lateral);
  void add_lane(LaneKind kind, int left_line, int right_line);
  void add_shoulder(int left_line, Stretch stretch);
  /// Where the main lanes have none.
  void leave_out_shoulder(Stretch stretch) { without_shoulder_.push_back(stretch); }
  void add_ghost(RoadLine line);

  /// Paints a line anew from a station on.
  void paint(int index, double from, PaintStyle style);
  [[nodiscard]] PaintStyle edge_style() const;
  [[nodiscard]] PaintStyle lane_line_style(double phase) const;

  /// The paint of lines from this index on is missing there.
  void remove_paint(int from_line, Stretch stretch);

  [[nodiscard]] RoadParts finished() const;

 private:
  RoadPreset preset_;
  double length_;
  double lane_width_;
  RoadParts parts_;
  std::vector<RoadLine> ghosts_;
  std::vector<Stretch> without_shoulder_;
};

}  // namespace lanefuse
