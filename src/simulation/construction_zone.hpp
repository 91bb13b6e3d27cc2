// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/road_draft.hpp"

namespace lanefuse {

/// Yellow lines lead narrowed lanes to one side and back again; the white lines stay where they were, as
/// ghosts.
void add_construction_zone(RoadDraft& draft, Stretch stretch, Random& random);

/// Both guard rails look like broken lines of paint.
void add_rail_ghosts(RoadDraft& draft, Stretch stretch);

}  // namespace lanefuse
