// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "roadmap/road_map.hpp"
#include "simulation/preset.hpp"
#include "simulation/road.hpp"

namespace lanefuse {

/// A road to drive on, from a map: along its longest chain of driving lanes, with every lane beside it that
/// goes the same way. Its places in the world are the map's; its lines lie within 2 cm of the map's
/// boundaries. What a map does not know comes from the preset: dashes, hills, guard rails. A boundary of
/// unknown style is painted solid at the outer edge, dashed between lanes. Throws an input error that names
/// `place` where the map has no such chain of at least 200 m.
Road road_from_map(const RoadMap& map, const RoadPreset& preset, std::uint64_t seed,
                   const std::string& place);

}  // namespace lanefuse
