// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/image_faces.hpp"
#include "simulation/road_ahead.hpp"
#include "simulation/road_parts.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

inline constexpr double kBridgeClearance = 5;  ///< [m] from the road to the deck

/// Where bridges lead over the road, from where it gets dark under them to where it gets light again: one on
/// a kilometre or so, the same in every scene of a seed.
std::vector<Stretch> bridges_over(const Stretch& road, std::uint64_t seed);

/// Their decks and the walls that they rest on.
void add_bridges(const Scene& scene, const RoadAhead& road, std::uint64_t seed, ImageFaces& faces);

}  // namespace lanefuse
