// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/radar_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

using Matrix34 = Eigen::Matrix<double, 3, 4>;

/// Observes position and the speed along the line of sight.
Matrix34 observation(const Eigen::Vector2d& sight) {
  Matrix34 jacobian = Matrix34::Zero();
  jacobian.topLeftCorner<2, 2>().setIdentity();
  jacobian.row(2).tail<2>() = sight.transpose();
  return jacobian;
}

}  // namespace

/// A detection over ground.
struct RadarTracker::Reflection {
  const RadarDetection* detection = nullptr;
  Eigen::Vector3d measured;  ///< x, y, speed over ground along the line of sight
  Eigen::Matrix3d noise;
  Matrix34 jacobian;
};

RadarTracker::Reflection RadarTracker::make_reflection(const RadarDetection& detection,
                                                       const Viewpoint& viewpoint) const {
  const double angle = viewpoint.odometry_from_radar.heading + detection.bearing;
  const Eigen::Vector2d sight(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d position = viewpoint.odometry_from_radar.position() + detection.range * sight;
  const double bearing = config_.sigma_bearing_deg * std::numbers::pi / 180 * detection.range;
  const Eigen::Vector2d sigma(config_.sigma_range, std::hypot(bearing, config_.sigma_lateral));

  Reflection reflection;
  reflection.detection = &detection;
  reflection.measured << position, detection.range_rate + viewpoint.velocity.dot(sight);
  reflection.noise.setZero();
  const Eigen::Matrix2d turn = rotation(angle);
  reflection.noise.topLeftCorner<2, 2>() = turn * sigma.cwiseAbs2().asDiagonal() * turn.transpose();
  reflection.noise(2, 2) = config_.sigma_range_rate * config_.sigma_range_rate;
  reflection.jacobian = observation(sight);
  return reflection;
}

bool RadarTracker::update(const RadarScan& scan, const Viewpoint& viewpoint) {
  const Time now = scan.stamp.measured_at;
  if (last_scan_ && now < *last_scan_) return false;
  const double seconds = last_scan_ ? to_seconds(now - *last_scan_) : 0;
  last_scan_ = now;
  for (Track& track : tracks_) predict(track, seconds);

  std::vector<char> taken(tracks_.size(), 0);
  std::vector<Reflection> fresh;
  for (const Reflection& reflection : one_a_vehicle(scan, viewpoint)) {
    Track* track = match(reflection, taken);
    if (!track) {
      fresh.push_back(reflection);
      continue;
    }
    taken[static_cast<std::size_t>(track - tracks_.data())] = 1;
    correct(*track, reflection, now);
  }
  for (const Reflection& reflection : fresh) start(reflection, now);
  forget(now);
  return true;
}

bool RadarTracker::is_same_vehicle(const Reflection& a, const Reflection& b) const {
  const Eigen::Vector2d sight = a.jacobian.row(2).tail<2>().transpose();
  const Eigen::Vector2d apart = (b.measured - a.measured).head<2>();
  const double along = apart.dot(sight);
  const double across = apart.dot(Eigen::Vector2d(-sight.y(), sight.x()));
  return std::abs(along) < config_.same_along && std::abs(across) < config_.same_across &&
         std::abs(b.measured[2] - a.measured[2]) < config_.same_range_rate;
}

std::vector<RadarTracker::Reflection> RadarTracker::one_a_vehicle(const RadarScan& scan,
                                                                  const Viewpoint& viewpoint) const {
  // The first of a vehicle's reflections stands for it: a mean would jump whenever one comes or goes.
  std::vector<Reflection> kept;
  for (const RadarDetection& detection : scan.detections) {
    const Reflection reflection = make_reflection(detection, viewpoint);
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Reflection& other) {
      return is_same_vehicle(other, reflection);
    });
    if (!known) kept.push_back(reflection);
  }
  return kept;
}

void RadarTracker::predict(Track& track, double seconds) const {
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition(0, 2) = transition(1, 3) = seconds;
  const Eigen::Vector2d velocity = track.state.mean.tail<2>();
  const Eigen::Matrix2d turn = rotation(std::atan2(velocity.y(), velocity.x()));
  const Eigen::Vector2d density(config_.acceleration_along, config_.acceleration_across);
  const Eigen::Matrix2d acceleration = turn * density.cwiseAbs2().asDiagonal() * turn.transpose();
  Eigen::Matrix4d noise;
  noise << acceleration * (seconds * seconds * seconds / 3), acceleration * (seconds * seconds / 2),
      acceleration * (seconds * seconds / 2), acceleration * seconds;
  lanefuse::predict<4>(track.state, transition, noise);
}

double RadarTracker::distance_squared(const Track& track, const Reflection& reflection) const {
  const Eigen::Vector3d residual = reflection.measured - reflection.jacobian * track.state.mean;
  return innovation<4, 3>(track.state, residual, reflection.jacobian, reflection.noise).distance_squared();
}

RadarTracker::Track* RadarTracker::match(const Reflection& reflection, const std::vector<char>& taken) {
  Track* nearest = nullptr;
  double nearest_distance = config_.gate;
  const bool has_address = reflection.detection->address && !reflection.detection->new_track;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (taken[i] != 0) continue;
    const double distance = distance_squared(tracks_[i], reflection);
    // The radar's own word, if it is not absurd, beats nearness.
    if (has_address && tracks_[i].address == reflection.detection->address && distance < 2 * config_.gate) {
      return &tracks_[i];
    }
    if (distance >= nearest_distance) continue;
    nearest = &tracks_[i];
    nearest_distance = distance;
  }
  return nearest;
}

void RadarTracker::correct(Track& track, const Reflection& reflection, Time time) const {
  const Eigen::Vector3d residual = reflection.measured - reflection.jacobian * track.state.mean;
  lanefuse::update<4, 3>(track.state, residual, reflection.jacobian, reflection.noise);
  track.address = reflection.detection->address;
  track.last_seen = time;
  ++track.hits;
}

void RadarTracker::start(const Reflection& reflection, Time time) {
  Track track;
  track.id = next_id_++;
  track.address = reflection.detection->address;
  track.last_seen = time;
  track.hits = 1;
  // The speed along the line of sight is measured, that across it is little known.
  const Eigen::Vector2d sight = reflection.jacobian.row(2).tail<2>().transpose();
  track.state.mean << reflection.measured.head<2>(), reflection.measured[2] * sight;
  track.state.covariance.setZero();
  track.state.covariance.topLeftCorner<2, 2>() = reflection.noise.topLeftCorner<2, 2>();
  const double along = config_.sigma_range_rate;
  const double across = config_.start_sigma_across;
  track.state.covariance.bottomRightCorner<2, 2>() =
      across * across * Eigen::Matrix2d::Identity() +
      (along * along - across * across) * sight * sight.transpose();
  tracks_.push_back(track);
}

void RadarTracker::forget(Time now) {
  std::erase_if(tracks_, [&](const Track& track) {
    const bool confirmed = track.hits >= config_.confirm_hits;
    return to_seconds(now - track.last_seen) > (confirmed ? config_.coast_s : config_.tentative_coast_s);
  });
}

std::vector<TrackedObject> RadarTracker::tracks(const Pose2& odometry_from_vehicle) const {
  std::vector<TrackedObject> objects;
  const Pose2 vehicle_from_odometry = odometry_from_vehicle.inverse();
  const Eigen::Matrix2d turn = rotation(vehicle_from_odometry.heading);
  for (const Track& track : tracks_) {
    if (track.hits < config_.confirm_hits) continue;
    const Eigen::Vector2d position = vehicle_from_odometry * Eigen::Vector2d(track.state.mean.head<2>());
    const Eigen::Vector2d velocity = turn * track.state.mean.tail<2>();
    TrackedObject object;
    object.id = track.id;
    object.x = position.x();
    object.y = position.y();
    object.speed = velocity.norm();
    object.movement = object.speed > config_.min_speed ? MovementState::moving : MovementState::stationary;
    object.seen_by_radar = true;
    object.heading = std::atan2(velocity.y(), velocity.x());
    const Eigen::Matrix2d velocity_covariance =
        turn * track.state.covariance.bottomRightCorner<2, 2>() * turn.transpose();
    const Eigen::Vector2d normal = Eigen::Vector2d(-velocity.y(), velocity.x()) / std::max(object.speed, 0.1);
    const double across = std::sqrt(normal.dot(velocity_covariance * normal));
    const double heading_sigma = std::min(across / std::max(object.speed, 0.1), std::numbers::pi);
    object.covariance.setZero();
    object.covariance.topLeftCorner<2, 2>() =
        turn * track.state.covariance.topLeftCorner<2, 2>() * turn.transpose();
    object.covariance(2, 2) = heading_sigma * heading_sigma;
    objects.push_back(object);
  }
  return objects;
}

void RadarTracker::reset() {
  tracks_.clear();
  last_scan_.reset();
  next_id_ = 1;
}

}  // namespace lanefuse
