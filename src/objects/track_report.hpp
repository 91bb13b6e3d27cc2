// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pose2.hpp"
#include "objects/object_track.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// A track as the rest of the program knows objects: in the vehicle frame, with its heading from its
/// velocity.
TrackedObject described(const ObjectTrack& track, const Pose2& vehicle_from_odometry,
                        const ObjectTrackerConfig& config);

}  // namespace lanefuse
