// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/object_track.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "core/pose2.hpp"
#include "objects/track_shape.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUnknownSpeed = 1e3;  ///< [m/s] sigma where the sensor measures none
constexpr double kLengthDrift = 0.05;  ///< [m/sqrt(s)] by which a length that was believed becomes doubtful

Eigen::Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
Eigen::Vector2d left_of(const Eigen::Vector2d& ahead) { return {-ahead.y(), ahead.x()}; }

Eigen::Matrix2d spread(double angle, double along, double across) {
  const Eigen::Matrix2d turn = rotation(angle);
  return turn * Eigen::Vector2d(along * along, across * across).asDiagonal() * turn.transpose();
}

TrackObservation observe_place(const ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
                               double bearing) {
  const double angle = look.odometry_from_sensor.heading + bearing;
  const Eigen::Vector2d sight = direction(angle);
  const Eigen::Vector2d place = look.odometry_from_sensor.position() + sighting.range * sight;
  TrackObservation observation;
  observation.residual.head<2>() = place - track.position();
  const double speed = sighting.range_rate ? *sighting.range_rate + look.velocity.dot(sight) : 0;
  observation.residual[2] = sighting.range_rate ? speed - sight.dot(track.velocity()) : 0;
  observation.jacobian.setZero();
  observation.jacobian.topLeftCorner<2, 2>().setIdentity();
  observation.jacobian.block<1, 2>(2, kTrackVx) = sight.transpose();
  observation.noise.setZero();
  observation.noise.topLeftCorner<2, 2>() =
      spread(angle, sighting.range_sigma, sighting.bearing_sigma * sighting.range);
  const double sigma = sighting.range_rate ? sighting.range_rate_sigma : kUnknownSpeed;
  observation.noise(2, 2) = sigma * sigma;
  return observation;
}

/// The box's middle is that of all that is seen of the vehicle, a flank included that is as long as the track
/// supposes.
TrackObservation observe_box(const ObjectTrack& track, const SightingSet& look, const Sighting& sighting) {
  constexpr double kBody = 0.08;  // [m] by which a body's middle is not that of its box
  constexpr double kStep = 0.5;   // [m]
  const double length = track.length();
  const double middle = silhouette(track, look, length, track.width).middle;
  const double shifted = silhouette(track, look, length + kStep, track.width).middle;
  TrackObservation observation = observe_place(track, look, sighting, sighting.bearing - middle);
  // Only a doubt: a camera's errors last too long to measure a length by.
  const double length_sigma = std::sqrt(track.state.covariance(kTrackLength, kTrackLength));
  const double doubt = std::hypot(kBody, (shifted - middle) / kStep * length_sigma * sighting.range);
  observation.noise.topLeftCorner<2, 2>() += spread(track.heading, 0, doubt);
  return observation;
}

}  // namespace

void Verification::add(double evidence, const ObjectTrackerConfig& config) {
  odds = std::clamp(odds + evidence, 2 * config.refused_odds, config.most_odds);
  if (odds > config.verified_odds) verified = true;
  if (odds < config.refused_odds) verified = false;
}

ObjectTrack start_track(const SightingSet& look, const Sighting& sighting, const ObjectTrackerConfig& config,
                        double own_heading) {
  ObjectTrack track;
  track.heading = own_heading;
  track.odds = config.start_odds;
  track.address = sighting.address;
  auto& [mean, covariance] = track.state;
  covariance.setZero();
  mean[kTrackLength] = kCarLength;
  const double angle = look.odometry_from_sensor.heading + sighting.bearing;
  const Eigen::Vector2d place = look.odometry_from_sensor.position() + sighting.range * direction(angle);
  // Of what is behind us the front is seen.
  const Eigen::Vector2d ahead = direction(own_heading);
  const bool behind = (place - look.odometry_from_vehicle.position()).dot(ahead) < -track.length();
  mean.segment<2>(kTrackX) = behind ? Eigen::Vector2d(place - track.length() * ahead) : place;
  covariance.block<2, 2>(kTrackX, kTrackX) =
      spread(angle, sighting.range_sigma, sighting.bearing_sigma * sighting.range) +
      spread(own_heading, config.depth, config.scatter);
  covariance.block<2, 2>(kTrackVx, kTrackVx) =
      spread(own_heading, config.start_sigma_along, config.start_sigma_across);
  covariance(kTrackWander, kTrackWander) = config.wander_sigma * config.wander_sigma;
  covariance(kTrackLength, kTrackLength) = kCarLengthSigma * kCarLengthSigma;
  if (behind) {
    const double variance = covariance(kTrackLength, kTrackLength);
    covariance.block<2, 2>(kTrackX, kTrackX) += variance * ahead * ahead.transpose();
    covariance.block<2, 1>(kTrackX, kTrackLength) = -variance * ahead;
    covariance.block<1, 2>(kTrackLength, kTrackX) = -variance * ahead.transpose();
  }
  if (sighting.range_rate) {
    // Only the speed is taken from the sighting that the track stands on already.
    const Eigen::Vector2d sight = direction(angle);
    Eigen::Matrix<double, 1, kTrackStateSize> jacobian = Eigen::Matrix<double, 1, kTrackStateSize>::Zero();
    jacobian.segment<2>(kTrackVx) = sight.transpose();
    const Eigen::Matrix<double, 1, 1> residual(*sighting.range_rate + look.velocity.dot(sight));
    const Eigen::Matrix<double, 1, 1> noise(sighting.range_rate_sigma * sighting.range_rate_sigma);
    update<kTrackStateSize, 1>(track.state, residual, jacobian, noise);
  } else {
    mean.segment<2>(kTrackVx) = look.velocity;
  }
  return track;
}

void predict(ObjectTrack& track, double seconds, const Eigen::Vector2d& own_position, double curvature,
             const ObjectTrackerConfig& config) {
  using StateMatrix = Eigen::Matrix<double, kTrackStateSize, kTrackStateSize>;
  const double keep = std::exp(-seconds / config.wander_tau);
  StateMatrix transition = StateMatrix::Identity();
  transition(kTrackX, kTrackVx) = transition(kTrackY, kTrackVy) = seconds;
  transition(kTrackWander, kTrackWander) = keep;
  const Eigen::Matrix2d acceleration =
      spread(track.heading, config.acceleration_along, config.acceleration_across);
  StateMatrix noise = StateMatrix::Zero();
  noise.block<2, 2>(kTrackX, kTrackX) = acceleration * (seconds * seconds * seconds / 3);
  noise.block<2, 2>(kTrackX, kTrackVx) = noise.block<2, 2>(kTrackVx, kTrackX) =
      acceleration * (seconds * seconds / 2);
  noise.block<2, 2>(kTrackVx, kTrackVx) = acceleration * seconds;
  noise(kTrackWander, kTrackWander) = config.wander_sigma * config.wander_sigma * (1 - keep * keep);
  // Our own dead reckoning turns away: everything swings about us.
  const Eigen::Vector2d apart = track.position() - own_position;
  const double swing = config.ego_yaw_deg * kDegree;
  noise.block<2, 2>(kTrackX, kTrackX) +=
      left_of(apart) * left_of(apart).transpose() * (swing * swing * seconds);
  noise(kTrackLength, kTrackLength) = kLengthDrift * kLengthDrift * seconds;
  // Half of the turn before moving, half afterwards: the chord of the arc.
  const double turn = curvature * track.speed() * seconds;
  const auto turn_half = [&] {
    track.state.mean.segment<2>(kTrackVx) = (rotation(turn / 2) * track.velocity()).eval();
  };
  turn_half();
  predict<kTrackStateSize>(track.state, transition, noise);
  turn_half();
  track.heading = wrap_angle(track.heading + turn);
}

TrackObservation observe(const ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
                         const ObjectTrackerConfig& config) {
  if (look.kind == SightingKind::camera) return observe_box(track, look, sighting);
  TrackObservation observation = observe_place(track, look, sighting, sighting.bearing);
  const Eigen::Vector2d place = track.position() + observation.residual.head<2>();
  const SeenPoint point = seen_point(track, look, place, config);
  const Eigen::Vector2d ahead = direction(track.heading);
  const Eigen::Vector2d left = left_of(ahead);
  observation.residual.head<2>() -= point.along * ahead + point.across * left;
  observation.jacobian.block<2, 1>(0, kTrackLength) = point.along / track.length() * ahead;
  if (!point.flank) {
    observation.residual.head<2>() -= track.state.mean[kTrackWander] * left;
    observation.jacobian.block<2, 1>(0, kTrackWander) = left;
  }
  observation.noise.topLeftCorner<2, 2>() += spread(track.heading, point.along_sigma, point.across_sigma);
  return observation;
}

Misfit misfit(const ObjectTrack& track, const TrackObservation& observation) {
  const Innovation<TrackObservation::kSize> surprise = innovation<kTrackStateSize, TrackObservation::kSize>(
      track.state, observation.residual, observation.jacobian, observation.noise);
  return {surprise.distance_squared(), std::log(surprise.covariance.determinant())};
}

void update(ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
            const ObjectTrackerConfig& config) {
  const TrackObservation observation = observe(track, look, sighting, config);
  update<kTrackStateSize, TrackObservation::kSize>(track.state, observation.residual, observation.jacobian,
                                                   observation.noise);
  if (look.kind == SightingKind::camera) update_width(track, look, sighting);
  if (sighting.address) track.address = sighting.address;
}

}  // namespace lanefuse
