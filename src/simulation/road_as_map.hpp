// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "roadmap/road_map.hpp"
#include "sensors/truth.hpp"
#include "simulation/road.hpp"

namespace lanefuse {

/// The road as a map: the centre line of every line that bounds a lane, a point every metre of the reference
/// line and one at each end of the line; the lanes with their kinds; the hard shoulders as emergency lanes.
/// Ghost lines are left out: they bound nothing. Ids count from 1, from left to right.
RoadMap road_map(const Road& road);

/// The road as truth for the evaluation: the map without its emergency lanes.
TrueRoad true_road(const Road& road);

}  // namespace lanefuse
