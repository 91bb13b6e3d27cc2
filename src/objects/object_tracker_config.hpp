// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lanefuse {

/// How vehicles move, how they are seen, and what makes a track; docs/object-tracking.md says where the
/// numbers come from.
struct ObjectTrackerConfig {
  // How vehicles move.
  double acceleration_along = 1.1;   ///< [m/s^2/sqrt(Hz)] process noise along the motion
  double acceleration_across = 0.3;  ///< [m/s^2/sqrt(Hz)] across it: cars hardly move sideways
  double wander_sigma = 0.3;         ///< [m] of the reflecting point across the rear
  double wander_tau = 1;             ///< [s] for which it stays where it is
  double scatter = 0.25;             ///< [m] of single reflections about it, across
  double flank_sigma = 0.25;         ///< [m] of reflections on a flank, across
  double depth = 0.25;               ///< [m] of single reflections, along the vehicle
  double start_sigma_across = 0.7;   ///< [m/s] of a new track's speed across our own heading
  double start_sigma_along = 40;     ///< [m/s] along it
  double misalignment_deg = 0.08;    ///< [deg] that all of a sensor's looks share
  double ego_yaw_deg = 0.03;         ///< [deg/sqrt(s)] by which our own dead reckoning turns away
  // Which sighting belongs to which track.
  double gate = 14;              ///< squared Mahalanobis distance
  double sure_gate = 6;          ///< the same, within which a reflection is no new vehicle's
  double same_along = 3;         ///< [m] reflections of one scan within these three are one vehicle
  double same_across = 1.4;      ///< [m]
  double same_range_rate = 1.2;  ///< [m/s]
  // What makes a track: log odds.
  double start_odds = -1.4;
  double hit_odds = 1.6;            ///< a sighting adds at most
  double miss_share = 0.25;         ///< of log(1 - P_D): misses are no independent witnesses
  double most_odds = 8;             ///< more is never believed
  double confirm_odds = 3;          ///< a track is reported from here
  int confirm_hits = 4;             ///< and from so many looks in which it was seen
  double coast_s = 0.6;             ///< [s] a confirmed track lives on unseen where it should be seen
  double hidden_coast_s = 2.0;      ///< [s] the same hidden behind another, or in no sensor's field
  double lost_s = 6;                ///< [s] for which what came to its end is remembered, to be known again
  double same_again = 25;           ///< squared Mahalanobis distance of place and velocity within which it is
  double tentative_coast_s = 0.25;  ///< [s] before it is confirmed
  // What verifies it: log odds of each kind of sensor.
  double verified_odds = 6.5;  ///< verified from here
  double refused_odds = -3;    ///< and no longer, below here: it should have been seen, and was not
  double gap_s = 0.4;          ///< [s] out of sight, after which it may be another that comes back
  int run_hits = 4;            ///< looks that see it then, before it is verified again
  // What it is.
  double min_speed = 3;        ///< [m/s] over ground: slower, it stands
  double change_speed = 0.45;  ///< [m/s] across the road, from which a vehicle changes lane
  double change_s = 0.4;       ///< [s] for which it must go on
  /// [s] by which a look may come after later ones, and still count as if it had come in time.
  double window_s = 0.25;
};

}  // namespace lanefuse
