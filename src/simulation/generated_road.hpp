// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/road.hpp"
#include "simulation/road_event.hpp"

namespace lanefuse {

/// What a drawn road shall be.
struct RoadPlan {
  RoadKind kind = RoadKind::gentle;
  double length = 1000;           ///< [m] at least
  double start = 0;               ///< [m] station from which the events are counted
  std::vector<RoadEvent> events;  ///< along it; none: one width from end to end
};

/// Draws a motorway: the preset's curves, hills, lanes, lines and guard rails, and the plan's events. Throws
/// a configuration error where events overlap.
Road generated_road(const RoadPlan& plan, const RoadPreset& preset, std::uint64_t seed);

}  // namespace lanefuse
