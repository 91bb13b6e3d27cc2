// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/object_track.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "core/pose2.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUnknownSpeed = 1e3;  ///< [m/s] sigma where the sensor measures none
constexpr double kTruckWidth = 2.2;    ///< [m] wider is a truck or a bus
constexpr double kCarLength = 4.7;     ///< [m]
constexpr double kTruckLength = 12;    ///< [m]

Eigen::Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
Eigen::Vector2d left_of(const Eigen::Vector2d& ahead) { return {-ahead.y(), ahead.x()}; }

Eigen::Matrix2d spread(double angle, double along, double across) {
  const Eigen::Matrix2d turn = rotation(angle);
  return turn * Eigen::Vector2d(along * along, across * across).asDiagonal() * turn.transpose();
}

/// Which point of a vehicle a radar sees, from the middle of its rear, and how well that is known.
struct SeenPoint {
  double along = 0;         ///< [m]
  double across = 0;        ///< [m]
  double along_sigma = 0;   ///< [m]
  double across_sigma = 0;  ///< [m]
};

/// Of the faces that are turned to the sensor the one on which the measured place lies best: the end that is
/// nearer, anywhere along its width, or the flank, anywhere along its length.
SeenPoint seen_point(const ObjectTrack& track, const Eigen::Vector2d& sensor, const Eigen::Vector2d& place,
                     const ObjectTrackerConfig& config) {
  const Eigen::Vector2d ahead = direction(track.heading);
  const auto in_vehicle = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d from_rear = point - track.position();
    return Eigen::Vector2d(from_rear.dot(ahead), from_rear.dot(left_of(ahead)));
  };
  const Eigen::Vector2d from = in_vehicle(sensor);
  const Eigen::Vector2d at = in_vehicle(place);
  const double half = track.width / 2;
  const double length = track.length();
  const double flank_side = std::copysign(half, from.y());
  const SeenPoint end{from.x() > length / 2 ? length : 0, 0, config.depth, config.scatter};
  const SeenPoint flank{std::clamp(at.x(), 0.0, length), flank_side, 0.3 * length,
                        std::hypot(config.flank_sigma, track.width_sigma / 2)};
  // From straight ahead or behind, and from afar, no flank is seen.
  constexpr double kSlant = 0.12;
  const double off_side = std::abs(from.y()) - half;
  const double before_end = std::max({0.0, -from.x(), from.x() - length});
  if (off_side < kSlant * before_end || off_side < 0) return end;
  if (from.x() > 0 && from.x() < length) return flank;
  const double off_end = std::abs(at.x() - end.along);
  const double off_flank = std::hypot(at.y() - flank_side, std::max({0.0, -at.x(), at.x() - length}));
  // The corner belongs to the end, whose place along is worth more.
  return off_flank + config.depth < off_end ? flank : end;
}

/// [rad] From the middle of the rear to the middle of all that a camera sees of the vehicle.
double flank_angle(const ObjectTrack& track, const SightingSet& look) {
  const Eigen::Vector2d ahead = direction(track.heading);
  const Pose2 sensor_from_odometry = look.odometry_from_sensor.inverse();
  const auto bearing = [&](double along, double across) {
    const Eigen::Vector2d at =
        sensor_from_odometry * Eigen::Vector2d(track.position() + along * ahead + across * left_of(ahead));
    return std::atan2(at.y(), at.x());
  };
  const double half = track.width / 2;
  const double rear = bearing(0, 0);
  double low = 0;
  double high = 0;
  for (const double along : {0.0, track.length()}) {
    for (const double across : {-half, half}) {
      const double angle = wrap_angle(bearing(along, across) - rear);
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
  }
  return (low + high) / 2;
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

void update_width(ObjectTrack& track, const Sighting& sighting, double flank) {
  constexpr double kRelative = 0.12;  // of a width that the range enters
  constexpr double kNarrowFlank = 0.15;
  if (!sighting.angular_width || std::abs(flank) > kNarrowFlank * *sighting.angular_width) return;
  const double range = sighting.range;
  const double width = std::clamp(range * *sighting.angular_width, 1.4, 2.7);
  const double sigma = width * (kRelative + sighting.range_sigma / range);
  const double gain =
      track.width_sigma * track.width_sigma / (track.width_sigma * track.width_sigma + sigma * sigma);
  track.width += gain * (width - track.width);
  track.width_sigma = std::max(0.05, track.width_sigma * std::sqrt(1 - gain));
}

}  // namespace

void Verification::add(double evidence, const ObjectTrackerConfig& config) {
  odds = std::clamp(odds + evidence, 2 * config.refused_odds, config.most_odds);
  if (odds > config.verified_odds) verified = true;
  if (odds < config.refused_odds) verified = false;
}

double ObjectTrack::length() const {
  return std::max(seen_length, width > kTruckWidth ? kTruckLength : kCarLength);
}

ObjectTrack start_track(const SightingSet& look, const Sighting& sighting, const ObjectTrackerConfig& config,
                        double own_heading) {
  ObjectTrack track;
  track.heading = own_heading;
  track.odds = config.start_odds;
  track.address = sighting.address;
  auto& [mean, covariance] = track.state;
  covariance.setZero();
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

void predict(ObjectTrack& track, double seconds, const Eigen::Vector2d& own_position,
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
  predict<kTrackStateSize>(track.state, transition, noise);
}

TrackObservation observe(const ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
                         const ObjectTrackerConfig& config) {
  if (look.kind == SightingKind::camera) {
    const double flank = flank_angle(track, look);
    TrackObservation observation = observe_place(track, look, sighting, sighting.bearing - flank);
    constexpr double kFlankDoubt = 0.3;  // of a flank whose length is a guess
    constexpr double kBody = 0.08;       // [m] by which a body's middle is not that of its box
    const double doubt = std::hypot(kBody, kFlankDoubt * flank * sighting.range);
    observation.noise.topLeftCorner<2, 2>() += spread(track.heading, 0, doubt);
    return observation;
  }
  TrackObservation observation = observe_place(track, look, sighting, sighting.bearing);
  const Eigen::Vector2d place = track.position() + observation.residual.head<2>();
  const SeenPoint point = seen_point(track, look.odometry_from_sensor.position(), place, config);
  const Eigen::Vector2d ahead = direction(track.heading);
  const Eigen::Vector2d left = left_of(ahead);
  observation.residual.head<2>() -= point.along * ahead + point.across * left;
  if (point.across == 0) {
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
  if (look.kind == SightingKind::camera) update_width(track, sighting, flank_angle(track, look));
  if (sighting.address) track.address = sighting.address;
}

}  // namespace lanefuse
