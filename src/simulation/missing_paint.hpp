// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/road_draft.hpp"
#include "simulation/road_event.hpp"

namespace lanefuse {

/// Takes the event's share of the paint away within the stretch: all of it, or pieces here and there.
void remove_paint(RoadDraft& draft, const RoadEvent& event, Stretch stretch, Random& random);

}  // namespace lanefuse
