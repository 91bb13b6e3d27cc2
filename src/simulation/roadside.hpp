// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/image_faces.hpp"
#include "simulation/road_ahead.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

inline constexpr double kRailBottom = 0.43;  ///< [m] of a guard rail's beam over the road
inline constexpr double kRailTop = 0.75;     ///< [m]

/// Guard rails with their posts on both sides.
void add_guard_rails(const Scene& scene, const RoadAhead& road, ImageFaces& faces);

/// Trees beyond the guard rails: groups of them, the same in every scene.
void add_trees(const Scene& scene, const RoadAhead& road, std::uint64_t seed, ImageFaces& faces);

}  // namespace lanefuse
