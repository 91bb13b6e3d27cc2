// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/random.hpp"
#include "simulation/preset.hpp"
#include "simulation/reference_line.hpp"

namespace lanefuse {

/// Draws at least `length` metres of motorway the way German rules (RAA 2008) lay it out: arcs of a radius in
/// `radius`, clothoid transitions with R/3 <= A <= R between them, S-curves without a straight in between,
/// now and then a straight. The course keeps within about a right angle of its first direction, so that it
/// never meets itself.
std::vector<RoadElement> draw_road_course(Range radius, double length, Random& random);

}  // namespace lanefuse
