// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// The left boundaries of the longest chain of driving lanes that follow one another, as one polyline; empty
/// where the map has no driving lane.
std::vector<Eigen::Vector2d> longest_lane_chain(const RoadMap& map);

}  // namespace lanefuse
