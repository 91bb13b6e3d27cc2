// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sensors/truth.hpp"
#include "simulation/preset.hpp"
#include "simulation/reference_line.hpp"
#include "simulation/road_height.hpp"

namespace lanefuse {

enum class RoadKind : std::uint8_t { gentle = 0, curved = 1 };
const char* to_string(RoadKind kind);

/// A motorway: lanes of one width around a reference line, their markings, shoulders and guard rails.
///
/// A place on it is (station, lateral): the arc length along the reference line and the offset across it,
/// positive to the left. Boundaries and lanes are numbered from left to right, from zero.
class Road {
 public:
  Road(RoadKind kind, double length, const RoadPreset& preset, std::uint64_t seed);

  [[nodiscard]] const ReferenceLine& reference() const { return reference_; }
  [[nodiscard]] const RoadHeight& height() const { return height_; }

  [[nodiscard]] int lane_count() const { return preset_.lanes; }
  [[nodiscard]] int boundary_count() const { return preset_.lanes + 1; }
  [[nodiscard]] double lane_width() const { return lane_width_; }
  [[nodiscard]] double lane_centre(int lane) const;
  [[nodiscard]] double boundary_lateral(int boundary) const;
  /// The lane that `lateral` lies in; beyond the edges the outermost.
  [[nodiscard]] int lane_at(double lateral) const;

  [[nodiscard]] bool is_edge(int boundary) const { return boundary == 0 || boundary == preset_.lanes; }
  [[nodiscard]] MarkingEvidence marking(int boundary) const;
  [[nodiscard]] double marking_width(int boundary) const;
  /// Whether there is paint: edge lines are solid, the others dashed.
  [[nodiscard]] bool painted(int boundary, double station) const;
  /// Lateral place of the guard rail on the left (+1) or right (-1).
  [[nodiscard]] double guard_rail(int side) const;

  /// The world pose of a place, heading along the road.
  [[nodiscard]] Pose2 pose(double station, double lateral) const;
  /// Curvature of the line at `lateral`, parallel to the reference line.
  [[nodiscard]] double curvature(double station, double lateral) const;

 private:
  Road(RoadKind kind, double length, const RoadPreset& preset, Random shape, Random heights);

  RoadPreset preset_;
  ReferenceLine reference_;
  RoadHeight height_;
  double lane_width_;
  std::vector<double> dash_phases_;  ///< [m] one a boundary
};

/// The road as truth: the centre line of every marking, a point every metre of the reference line.
TrueRoad true_road(const Road& road);

}  // namespace lanefuse
