// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/road_draft.hpp"

namespace lanefuse {

/// Lanes on the right of the main ones that begin or end, with the lengths of German rules (RAA 2008).

inline constexpr double kRampLane = 250;  ///< [m] of an exit or entry lane, with its taper
inline constexpr double kTaper = 60;      ///< [m] on which a lane opens or closes beside a ramp
inline constexpr double kRamp = 150;      ///< [m] on which a ramp leaves the road, or comes to it

/// A lane opens, runs along and leaves with the ramp, all within the stretch.
void add_exit(RoadDraft& draft, Stretch stretch);
/// A ramp comes, runs along as a lane and ends, all within the stretch.
void add_entry(RoadDraft& draft, Stretch stretch);
/// A lane opens at the beginning of the stretch and is closed by its end.
void add_ending_lane(RoadDraft& draft, Stretch stretch);

}  // namespace lanefuse
