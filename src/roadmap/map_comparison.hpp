// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// How far lines lie from the true ones, across [m]; positive to the left.
struct LineDeviation {
  std::size_t count = 0;  ///< points of the map that were compared
  double mean = 0;
  double rmse = 0;
  double p95 = 0;  ///< of the magnitude
  double max = 0;  ///< of the magnitude
};

/// One true boundary against whatever of the map lies along it.
struct BoundaryComparison {
  std::uint64_t id = 0;  ///< of the true boundary
  double length = 0;     ///< [m] of the true boundary
  double covered = 0;    ///< [m] of it that the map has
  LineDeviation deviation;
  /// Place along the true boundary [m] and deviation [m], in order.
  std::vector<Eigen::Vector2d> points;
};

struct MapComparison {
  std::vector<BoundaryComparison> boundaries;
  LineDeviation all;
  double covered_share = 0;  ///< of the true boundaries' length
  std::size_t strays = 0;    ///< points of the map that lie along no true boundary
};

/// Compares every point of the map's boundaries with the true boundary that runs nearest to its line. Where
/// both know where on Earth they are, the truth is brought into the map's frame; otherwise they share one.
MapComparison compare(const RoadMap& map, const RoadMap& truth);

/// An exact road as a map, to be compared with.
RoadMap as_map(const TrueRoad& road, const std::optional<GeoOrigin>& origin);

}  // namespace lanefuse
