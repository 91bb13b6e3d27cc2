// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "objects/object_track.hpp"

namespace lanefuse {

/// How long vehicles are [m]: two hypotheses, of which a track holds one.
inline constexpr double kCarLength = 4.6;
inline constexpr double kCarLengthSigma = 0.6;
inline constexpr double kTruckLength = 13;
inline constexpr double kTruckLengthSigma = 2.2;

/// Which point of a vehicle a radar sees, from the middle of its rear, and how well that is known.
struct SeenPoint {
  double along = 0;         ///< [m]
  double across = 0;        ///< [m]
  double along_sigma = 0;   ///< [m]
  double across_sigma = 0;  ///< [m]
  bool flank = false;
};

/// Of the faces that are turned to the sensor the one on which the measured place lies best: the end that is
/// nearer, anywhere along its width, or the flank, anywhere along what of it lies in the sensor's field.
SeenPoint seen_point(const ObjectTrack& track, const SightingSet& look, const Eigen::Vector2d& place,
                     const ObjectTrackerConfig& config);

/// All that a sensor sees of a vehicle [rad]: where its middle is from the middle of the rear, and its width.
struct Silhouette {
  double middle = 0;
  double width = 0;
};
Silhouette silhouette(const ObjectTrack& track, const SightingSet& look, double length, double width);

/// The width by what a camera's box spans, once the range is known; and by it whether this is a truck.
void update_width(ObjectTrack& track, const SightingSet& look, const Sighting& sighting);

/// Another length, and with it all that was known only by the old one: the rear, where the front was seen.
void suppose_length(ObjectTrack& track, double length, double sigma);

}  // namespace lanefuse
