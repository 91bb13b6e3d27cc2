// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/passed_thing.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace lanefuse {
namespace {

constexpr double kWander = 0.15;  ///< [m] of a reflection on its thing

Eigen::Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

Eigen::Vector2d place_of(const SightingSet& look, const Sighting& sighting) {
  return look.odometry_from_sensor.position() +
         sighting.range * direction(look.odometry_from_sensor.heading + sighting.bearing);
}

/// The radar's place, but turned as the car is.
Pose2 radar_pose(const SightingSet& look) {
  return {look.odometry_from_sensor.x, look.odometry_from_sensor.y, look.odometry_from_vehicle.heading};
}

}  // namespace

PassedThing::PassedThing(const SightingSet& look, const Sighting& sighting)
    : first_seen_(look.measured_at),
      last_seen_(look.measured_at),
      first_from_odometry_(radar_pose(look).inverse()),
      place_(place_of(look, sighting)),
      range_(sighting.range) {
  const Eigen::Vector2d at = first_from_odometry_ * place_;
  nearest_ = farthest_ = at.x();
  across_ = at.y();
  add(look, sighting);
}

bool PassedThing::fits(const SightingSet& look, const Sighting& sighting) const {
  constexpr double kAlong = 1;     // [m] about where it should be
  constexpr double kAcross = 0.3;  // [m] the same, beside what bearings are off by
  constexpr double kSigmas = 3.5;  // of the bearings
  const double angle = look.odometry_from_sensor.heading + sighting.bearing;
  const Eigen::Vector2d apart = rotation(-angle) * (place_of(look, sighting) - place_);
  const double sigma = sighting.bearing_sigma * std::hypot(sighting.range, range_);
  return std::abs(apart.x()) < kAlong && std::abs(apart.y()) < kAcross + kSigmas * sigma;
}

void PassedThing::add(const SightingSet& look, const Sighting& sighting) {
  last_seen_ = look.measured_at;
  place_ = place_of(look, sighting);
  range_ = sighting.range;
  const Eigen::Vector2d at = first_from_odometry_ * place_;
  const double driven = (first_from_odometry_ * look.odometry_from_sensor.position()).x();
  const double ahead = at.x() - driven;
  const double seconds = to_seconds(look.measured_at - first_seen_);
  nearest_ = std::min(nearest_, ahead);
  farthest_ = std::max(farthest_, ahead);
  const double sigma = std::hypot(sighting.bearing_sigma * ahead, kWander);
  const Eigen::Vector3d slope(1, ahead, seconds * (driven / 2 + ahead));
  const double surprise = at.y() - across_;
  information_ += slope * slope.transpose() / (sigma * sigma);
  vector_ += slope * (surprise / (sigma * sigma));
  squares_ += surprise * surprise / (sigma * sigma);
  ++sightings_;
}

bool PassedThing::is_over(const SightingSet& look) const {
  constexpr double kMemory = 4;  // [s] out of sight
  const Pose2 radar_from_odometry = look.odometry_from_sensor.inverse();
  const bool behind = (radar_from_odometry * place_).x() < 0;
  return behind || to_seconds(look.measured_at - last_seen_) > kMemory;
}

void PassedThing::tell(Gaussian<kRadarTurnSize>& turn) const {
  constexpr double kLeastWay = 20;  // [m]
  constexpr int kLeastSightings = 3;
  constexpr double kWorst = 3;  // times as far off as it should be
  if (sightings_ < kLeastSightings || std::abs(farthest_ - nearest_) < kLeastWay) return;
  // Where it lies is of no interest.
  const Eigen::Vector2d coupling = information_.block<2, 1>(1, 0) / information_(0, 0);
  const Eigen::Matrix2d information =
      information_.bottomRightCorner<2, 2>() - coupling * information_.block<1, 2>(0, 1);
  const Eigen::Vector2d vector = vector_.tail<2>() - coupling * vector_[0];
  const double squares = squares_ - vector_[0] * vector_[0] / information_(0, 0);
  const double off = squares - 2 * turn.mean.dot(vector) + turn.mean.dot(information * turn.mean);
  if (off > kWorst * (sightings_ - 1 + (information * turn.covariance).trace())) return;
  const Eigen::Matrix2d before = turn.covariance;
  const Eigen::Vector2d surprise = vector - information * turn.mean;
  const Eigen::Matrix2d after = (Eigen::Matrix2d::Identity() + before * information).inverse() * before;
  turn.covariance = (after + after.transpose()) / 2;
  turn.mean += turn.covariance * surprise;
}

}  // namespace lanefuse
