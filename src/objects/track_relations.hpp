// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "objects/object_track.hpp"

namespace lanefuse {

/// Whether it surely goes faster than `min_speed` [m/s] along its heading: what is passed by seems to move
/// across.
bool surely_drives(const ObjectTrack& track, double min_speed);

/// What drives exactly beside another, further away than a road of three lanes is wide, with our own car on
/// the same side of the middle between them, is that other one in the mirror of a guard rail in that middle.
bool is_mirror_of(const ObjectTrack& ghost, const ObjectTrack& real, const Eigen::Vector2d& own_position);

/// Whether a new track may go on from one that has not been seen for a while: by place and velocity, whose
/// squared Mahalanobis distance stays within the gate, and by the lane.
bool may_be_same(const ObjectTrack& young, const ObjectTrack& gone, double gate, double& distance_squared);

/// Gives the new track the name of the one that it goes on from, and what was known of its body; not what
/// verified it: a false word would make a false witness.
void take_name(ObjectTrack& young, const ObjectTrack& gone);

/// Two tracks of one vehicle, of which the older one stays. `same_along` [m] apart they may be.
bool is_double(const ObjectTrack& young, const ObjectTrack& old, double same_along);

/// Drops what is superseded, and of two tracks of one vehicle the younger one; the name that was reported
/// first stays.
void merge_doubles(std::vector<ObjectTrack>& tracks, double same_along);

}  // namespace lanefuse
