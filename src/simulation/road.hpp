// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "core/feature.hpp"
#include "roadmap/road_map.hpp"
#include "simulation/preset.hpp"
#include "simulation/reference_line.hpp"
#include "simulation/road_height.hpp"
#include "simulation/road_parts.hpp"

namespace lanefuse {

enum class RoadKind : std::uint8_t { gentle = 0, curved = 1, sharp = 2 };
const char* to_string(RoadKind kind);

/// A motorway: lines, lanes, shoulders and guard rails along a reference line.
///
/// A place on it is (station, lateral): the arc length along the reference line and the offset across it,
/// positive to the left. Lines and lanes are numbered from zero, from left to right wherever two of them run
/// side by side; both begin, end and move across the road. What is asked of a line or a lane where it is not
/// (station, pose) is answered as if its end went on straight. The emergency lane is no lane here: nobody
/// drives there. It stands in the map.
class Road {
 public:
  /// A road of one width from end to end.
  Road(RoadKind kind, double length, const RoadPreset& preset, std::uint64_t seed);
  Road(ReferenceLine reference, RoadHeight height, RoadParts parts);

  [[nodiscard]] const ReferenceLine& reference() const { return reference_; }
  [[nodiscard]] const RoadHeight& height() const { return height_; }
  [[nodiscard]] const RoadParts& parts() const { return parts_; }
  [[nodiscard]] double length() const { return reference_.length(); }

  [[nodiscard]] int line_count() const { return static_cast<int>(parts_.lines.size()); }
  [[nodiscard]] bool line_exists(int line, double station) const;
  /// Whether any of the line lies in the stretch.
  [[nodiscard]] bool line_runs_within(int line, const Stretch& stretch) const;
  [[nodiscard]] double line_lateral(int line, double station) const;
  /// d lateral / d station: what the line turns against the road.
  [[nodiscard]] double line_slope(int line, double station) const;
  [[nodiscard]] MarkingEvidence marking(int line, double station) const;
  [[nodiscard]] double marking_width(int line, double station) const;
  /// Whether there is paint: not beyond the line's ends, in the gaps of its dashes, and where the paint is
  /// missing.
  [[nodiscard]] bool painted(int line, double station) const;
  /// The line's index, or kNoLine where it is a ghost, which bounds no lane.
  [[nodiscard]] LineLabel line_label(int line) const;

  /// All lanes that vehicles drive on, entries and exits among them.
  [[nodiscard]] int lane_count() const { return static_cast<int>(parts_.lanes.size()); }
  [[nodiscard]] bool lane_exists(int lane, double station) const;
  [[nodiscard]] LaneKind lane_kind(int lane) const { return lane_at_index(lane).kind; }
  [[nodiscard]] double lane_begin(int lane) const;  ///< [m] station
  [[nodiscard]] double lane_end(int lane) const;    ///< [m] station, not part of the lane
  [[nodiscard]] int left_line(int lane) const { return lane_at_index(lane).left_line; }
  [[nodiscard]] int right_line(int lane) const { return lane_at_index(lane).right_line; }
  [[nodiscard]] double lane_centre(int lane, double station) const;
  [[nodiscard]] double lane_centre_slope(int lane, double station) const;
  [[nodiscard]] double lane_width(int lane, double station) const;
  /// The lane that the place lies in; none beyond the edges and between diverging lanes.
  [[nodiscard]] std::optional<int> lane_at(double station, double lateral) const;
  /// As lane_at(), but only within `reach` [m] of the middle between the lane's two lines.
  [[nodiscard]] std::optional<int> lane_around(double station, double lateral, double reach) const;
  /// The lane beside `lane` on that side, if there is one that is wide enough there to be driven on.
  [[nodiscard]] std::optional<int> neighbour(int lane, Side side, double station) const;

  /// Of a road that is the same from end to end.
  [[nodiscard]] double lane_width() const { return lane_width(lane_count() / 2, 0); }

  /// Lateral place of the guard rail on the left (+1) or right (-1).
  [[nodiscard]] double guard_rail(int side, double station) const;

  /// The world pose of a place, heading along the road.
  [[nodiscard]] Pose2 pose(double station, double lateral) const;
  /// Curvature of the line at `lateral`, parallel to the reference line.
  [[nodiscard]] double curvature(double station, double lateral) const;

 private:
  ReferenceLine reference_;
  RoadHeight height_;
  RoadParts parts_;

  [[nodiscard]] const RoadLine& line_at_index(int line) const;
  [[nodiscard]] const RoadLane& lane_at_index(int lane) const;
};

inline constexpr double kDrivableWidth = 2.5;  ///< [m] of the narrowest lane that vehicles choose

}  // namespace lanefuse
