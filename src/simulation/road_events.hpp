// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/random.hpp"
#include "simulation/road_draft.hpp"
#include "simulation/road_event.hpp"

namespace lanefuse {

/// Lays the events onto the road, again and again as far as it goes; `start` [m] is the station of the
/// drive's start. Throws a configuration error where two that change lanes overlap.
void lay_events(std::span<const RoadEvent> events, double start, RoadDraft& draft, Random& random);

}  // namespace lanefuse
