// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roadmap/road_map.hpp"

namespace lanefuse {

enum class StripSide : std::uint8_t { left = 0, right = 1 };

/// One edge of a strip, along the strip's driving direction.
struct StripEdge {
  std::vector<Eigen::Vector3d> points;  ///< [m], at least two, no repeated ones
  std::vector<MarkingStyle> styles;     ///< as a MapBoundary's
};

/// A piece of one lane as formats have them (a lanelet, a lane of one section): as long as nothing beside it
/// begins or ends. Neighbours and successors are indices into the strips of the same map.
struct LaneStrip {
  std::uint64_t id = 0;
  LaneKind kind = LaneKind::driving;
  std::array<StripEdge, 2> edges;          ///< by StripSide
  std::optional<std::size_t> left_strip;   ///< neighbour in the same driving direction
  std::optional<std::size_t> right_strip;  ///< neighbour in the same driving direction
  std::vector<std::size_t> successors;

  [[nodiscard]] const StripEdge& edge(StripSide side) const { return edges[static_cast<std::size_t>(side)]; }
  [[nodiscard]] StripEdge& edge(StripSide side) { return edges[static_cast<std::size_t>(side)]; }
};

/// How many points a file's lanes may have altogether.
inline constexpr std::size_t kMostLanePoints = 2'000'000;

/// The strips as a map: neighbours share one boundary, and boundaries and lanes run on from strip to strip
/// for as long as nothing forks. Where the extents of a lane's two boundaries would not tell where the lane
/// ends, a boundary ends there, too. A lane has the id of its first strip; boundaries count from 1, from left
/// to right.
RoadMap join_strips(const std::vector<LaneStrip>& strips);

/// The points without those that are less than a centimetre from the one before; first and last are kept.
std::vector<Eigen::Vector3d> without_repeats(const std::vector<Eigen::Vector3d>& points);

double arc_length(const std::vector<Eigen::Vector3d>& points);

}  // namespace lanefuse
