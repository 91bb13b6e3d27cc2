// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "objects/object_track.hpp"

namespace lanefuse {

/// Whether it surely goes faster than `min_speed` [m/s] along its heading: what is passed by seems to move
/// across.
bool surely_drives(const ObjectTrack& track, double min_speed);

/// What drives exactly beside another, further away than a road of three lanes is wide, with our own car on
/// the same side of the middle between them, is that other one in the mirror of a guard rail in that middle.
bool is_mirror_of(const ObjectTrack& ghost, const ObjectTrack& real, const Eigen::Vector2d& own_position);

/// Two tracks of one vehicle, of which the older one stays. `same_along` [m] apart they may be.
bool is_double(const ObjectTrack& young, const ObjectTrack& old, double same_along);

}  // namespace lanefuse
