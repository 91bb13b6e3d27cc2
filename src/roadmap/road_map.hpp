// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/feature.hpp"
#include "sensors/geo_origin.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// How a boundary is painted from one place on, until the next style begins.
struct MarkingStyle {
  double from = 0;  ///< [m] of arc length along the boundary's points
  MarkingEvidence marking;
  double width = 0.15;  ///< [m] of the paint
  friend bool operator==(const MarkingStyle&, const MarkingStyle&) = default;
};

/// A boundary of lanes: the centre line of its paint (or the edge itself, where there is none) as a polyline
/// in the map's frame, along the driving direction.
struct MapBoundary {
  std::uint64_t id = 0;                 ///< unique in the map, not 0
  std::vector<Eigen::Vector3d> points;  ///< [m], at least two; z is 0 where the height is not known
  std::vector<MarkingStyle> styles;     ///< in order, at least one, the first from 0
};

enum class LaneKind : std::uint8_t {
  driving = 0,
  emergency = 1,  ///< hard shoulder: no lane that a car perceives as one
  entry = 2,
  exit = 3,
  other = 4,
};
const char* to_string(LaneKind kind);

/// The strip between two boundaries. A lane runs as far as both of its boundaries do.
struct MapLane {
  std::uint64_t id = 0;  ///< unique among the lanes, not 0
  LaneKind kind = LaneKind::driving;
  std::uint64_t left_boundary = 0;
  std::uint64_t right_boundary = 0;
  std::optional<std::uint64_t> left_lane;   ///< neighbour in the same driving direction
  std::optional<std::uint64_t> right_lane;  ///< neighbour in the same driving direction
  std::vector<std::uint64_t> successors;    ///< lanes that continue this one
};

/// A map of lanes. Every reader makes one, whatever its format; every writer takes one.
struct RoadMap {
  std::string name;
  std::optional<GeoOrigin> origin;
  std::vector<MapBoundary> boundaries;
  std::vector<MapLane> lanes;
};

/// The style that holds at `arc_length` [m] along the boundary.
const MarkingStyle& style_at(const MapBoundary& boundary, double arc_length);

const MapBoundary* find_boundary(const RoadMap& map, std::uint64_t id);
const MapLane* find_lane(const RoadMap& map, std::uint64_t id);

/// Throws an input error that names the first thing which is wrong: an id that is 0 or there twice, a
/// reference to what is not there, a line of fewer than two points, a number that is not finite.
/// `place` names the map in errors.
void check(const RoadMap& map, const std::string& place);

/// The map as truth for the evaluation: its boundaries with their prevailing style, all lanes but the
/// emergency lane, in the order in which they stand in the map.
TrueRoad true_road(const RoadMap& map);

}  // namespace lanefuse
