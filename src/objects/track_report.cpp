// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/track_report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

MovementState movement(const ObjectTrack& track, const ObjectTrackerConfig& config) {
  if (track.speed() > config.min_speed) return MovementState::moving;
  return track.has_moved ? MovementState::stopped : MovementState::stationary;
}

/// [rad] of the heading: of a direction of motion, by its part across.
double heading_sigma(const ObjectTrack& track) {
  constexpr double kSlowest = 0.5;  // [m/s]
  const Eigen::Vector2d across(-std::sin(track.heading), std::cos(track.heading));
  const double variance = across.dot(track.state.covariance.block<2, 2>(kTrackVx, kTrackVx) * across);
  return std::min(std::sqrt(std::max(variance, 1e-8)) / std::max(track.speed(), kSlowest), std::numbers::pi);
}

}  // namespace

TrackedObject described(const ObjectTrack& track, const Pose2& vehicle_from_odometry,
                        const ObjectTrackerConfig& config) {
  const Eigen::Vector2d position = vehicle_from_odometry * track.position();
  TrackedObject object;
  object.id = track.id;
  object.x = position.x();
  object.y = position.y();
  object.heading = wrap_angle(track.heading + vehicle_from_odometry.heading);
  object.speed = track.speed();
  const Eigen::Matrix2d turn = rotation(vehicle_from_odometry.heading);
  object.covariance.setZero();
  object.covariance.topLeftCorner<2, 2>() =
      turn * track.state.covariance.block<2, 2>(kTrackX, kTrackX) * turn.transpose();
  // All looks of a sensor that is turned a little lean the same way: the filter cannot average that out.
  const double lean = config.misalignment_deg * kDegree;
  const Eigen::Vector2d sideways(-position.y(), position.x());
  object.covariance.topLeftCorner<2, 2>() += lean * lean * sideways * sideways.transpose();
  const double sigma = std::hypot(heading_sigma(track), lean);
  object.covariance(2, 2) = sigma * sigma;
  object.length = track.length();
  object.width = track.width;
  object.movement = movement(track, config);
  object.existence = 1 / (1 + std::exp(-track.odds));
  // What comes back from behind others may be another: it bears no witness before it has been seen for a
  // while.
  const bool is_itself = track.run >= config.run_hits;
  object.seen_by_radar = track.radar.verified && is_itself;
  object.seen_by_camera = track.camera.verified && is_itself;
  object.last_radar = track.radar.last;
  object.last_camera = track.camera.last;
  object.changing_lane = track.changing_lane;
  return object;
}

}  // namespace lanefuse
