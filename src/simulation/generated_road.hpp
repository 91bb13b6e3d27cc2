// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "simulation/road.hpp"

namespace lanefuse {

/// Draws a motorway of one width from end to end, at least `length` [m] long: the preset's curves, hills,
/// lanes, lines and guard rails.
Road generated_road(RoadKind kind, double length, const RoadPreset& preset, std::uint64_t seed);

}  // namespace lanefuse
