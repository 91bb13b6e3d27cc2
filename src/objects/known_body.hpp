// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "objects/object_track.hpp"

namespace lanefuse {

/// Whether the sighting lies on the body of the vehicle, as fast as it is. Nobody follows so near at such a
/// speed: what is seen a little beyond its ends is more of the same vehicle, and after some more of it the
/// track is taken for a truck's, if no camera has said otherwise.
bool is_on_body(ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
                const ObjectTrackerConfig& config);

}  // namespace lanefuse
