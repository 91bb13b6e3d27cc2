// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sensors/truth.hpp"

namespace lanefuse {

/// Where the camera of comma2k19's cars sits behind the middle of the front axle [m]. Nobody measured it: the
/// camera is a windscreen device, in a RAV4 about 1.5 m behind the radar in the front grille. An error here
/// shifts the truth along the road only.
inline constexpr double kCommaCameraBehindFrontAxle = 0.65;

/// The car's poses in the plane (x east, y north, origin at the first camera position), one a camera frame,
/// from the folder global_pose of a segment.
///
/// Positions are the camera's, moved forward to the front axle. Headings are the camera's yaw minus the yaw
/// at which it is mounted, which is what a running mean over `kHeadingWindow` of (yaw - direction of travel)
/// leaves: the orientations are ten times less noisy than the direction of travel from one frame to the next
/// (0.1 against 0.7 mrad over one second), but wander against it by some mrad over a minute. See
/// docs/comma2k19.md.
std::vector<TrueFrame> read_comma2k19_poses(const std::filesystem::path& global_pose,
                                            std::vector<std::string>& notes);

/// The heading of the paragraph above, for each sample: `yaws` [rad] of the camera, `courses` [rad] of its
/// velocity, `speeds` [m/s]. Where the car is too slow for its course to mean anything in the whole window,
/// the mean over all samples stands in, and 0 if it is never fast enough.
std::vector<double> headings_without_mounting(const std::vector<Time>& times, const std::vector<double>& yaws,
                                              const std::vector<double>& courses,
                                              const std::vector<double>& speeds);

}  // namespace lanefuse
