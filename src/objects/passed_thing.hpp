// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/kalman.hpp"
#include "core/time.hpp"
#include "objects/sighting.hpp"

namespace lanefuse {

/// What is to be learned of a radar: its turn [rad], and the bias [rad/s] of the yaw rate that it is seen by.
enum RadarTurn : int { kTurn, kYawRateBias, kRadarTurnSize };

/// Something that stands and that a radar sees while the car passes it: the normal equations of its lateral
/// place, of the radar's turn and of the yaw rate's bias, in the frame in which it was seen first. What is
/// turned seems to lie to one side by so much for each metre that it is ahead; a bias bends the car's own
/// way.
class PassedThing {
 public:
  PassedThing(const SightingSet& look, const Sighting& sighting);

  /// Whether the sighting may be of it.
  [[nodiscard]] bool fits(const SightingSet& look, const Sighting& sighting) const;
  void add(const SightingSet& look, const Sighting& sighting);
  /// Whether it will not be seen again: it lies behind the radar, or has been out of sight for long.
  [[nodiscard]] bool is_over(const SightingSet& look) const;

  /// Hands over what it tells, unless it was seen over a short way only, or contradicts itself.
  void tell(Gaussian<kRadarTurnSize>& turn) const;

 private:
  Time first_seen_;
  Time last_seen_;
  Pose2 first_from_odometry_;  ///< the radar's place and the car's heading at first sight
  Eigen::Vector2d place_;      ///< when it was seen last, odometry frame
  double range_ = 0;           ///< [m] the same
  double nearest_ = 0;         ///< [m] ahead
  double farthest_ = 0;        ///< [m] ahead
  double across_ = 0;          ///< [m] at first sight: small numbers make sound sums
  int sightings_ = 0;
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d vector_ = Eigen::Vector3d::Zero();
  double squares_ = 0;
};

}  // namespace lanefuse
