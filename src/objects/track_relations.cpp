// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/track_relations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "objects/track_shape.hpp"

namespace lanefuse {

bool surely_drives(const ObjectTrack& track, double min_speed) {
  const Eigen::Vector2d ahead(std::cos(track.heading), std::sin(track.heading));
  const double variance = ahead.dot(track.state.covariance.block<2, 2>(kTrackVx, kTrackVx) * ahead);
  return std::abs(track.velocity().dot(ahead)) - 3 * std::sqrt(std::max(0.0, variance)) > min_speed;
}

bool is_mirror_of(const ObjectTrack& ghost, const ObjectTrack& real, const Eigen::Vector2d& own_position) {
  constexpr double kBeside = 4;        // [m] along
  constexpr double kFurtherOut = 8.4;  // [m] at least: twice the way from a lane's middle to the rail
  constexpr double kFurthest = 45;     // [m]
  constexpr double kAsFast = 1.5;      // [m/s] along
  const Eigen::Vector2d ahead(std::cos(real.heading), std::sin(real.heading));
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const Eigen::Vector2d apart = ghost.position() - real.position();
  const double across = apart.dot(left);
  if (std::abs(apart.dot(ahead)) > kBeside || std::abs(across) < kFurtherOut || std::abs(across) > kFurthest)
    return false;
  if (std::abs((ghost.velocity() - real.velocity()).dot(ahead)) > kAsFast) return false;
  const double own = (own_position - real.position()).dot(left);
  return (across > 0 ? own : -own) < std::abs(across) / 2;
}

bool may_be_same(const ObjectTrack& young, const ObjectTrack& gone, double gate, double& distance_squared) {
  constexpr double kAcross = 3.2;  // [m] beyond which it is on another lane, however uncertain both are
  const Eigen::Vector4d apart = young.state.mean.head<4>() - gone.state.mean.head<4>();
  const Eigen::Vector2d left(-std::sin(gone.heading), std::cos(gone.heading));
  if (std::abs(apart.head<2>().dot(left)) > kAcross) return false;
  const Eigen::Matrix4d doubt =
      young.state.covariance.topLeftCorner<4, 4>() + gone.state.covariance.topLeftCorner<4, 4>();
  distance_squared = apart.dot(doubt.llt().solve(apart));
  return distance_squared < gate;
}

void take_name(ObjectTrack& young, const ObjectTrack& gone) {
  young.id = gone.id;
  young.born = gone.born;
  young.has_moved = young.has_moved || gone.has_moved;
  young.width = gone.width;
  young.width_sigma = gone.width_sigma;
  suppose_length(young, gone.length(), std::sqrt(gone.state.covariance(kTrackLength, kTrackLength)));
}

bool is_double(const ObjectTrack& young, const ObjectTrack& old, double same_along) {
  constexpr double kAcross = 1.1;           // [m]
  constexpr double kMostDoubtAcross = 0.9;  // [m]
  constexpr double kAsFast = 2.5;           // [m/s]
  if (young.id <= old.id || !old.confirmed) return false;
  const Eigen::Vector2d ahead(std::cos(old.heading), std::sin(old.heading));
  const Eigen::Vector2d apart = young.position() - old.position();
  const double along = apart.dot(ahead);
  const double across = ahead.x() * apart.y() - ahead.y() * apart.x();
  const double doubt = std::sqrt(young.state.covariance.block<2, 2>(kTrackX, kTrackX).trace());
  // However little is known of one that others hide: what drives a lane further is another vehicle.
  return std::abs(across) < kAcross + std::min(doubt, kMostDoubtAcross) && along > -same_along - doubt &&
         along < old.length() - 0.5 && (young.velocity() - old.velocity()).norm() < kAsFast;
}

void merge_doubles(std::vector<ObjectTrack>& tracks, double same_along) {
  for (ObjectTrack& young : tracks) {
    if (young.superseded) continue;
    const auto old = std::find_if(tracks.begin(), tracks.end(), [&](const ObjectTrack& track) {
      return !track.superseded && is_double(young, track, same_along);
    });
    if (old == tracks.end()) continue;
    young.superseded = true;
    // The name that was reported first stays.
    if (young.confirmed && young.confirmed_at < old->confirmed_at) std::swap(young.id, old->id);
  }
  std::erase_if(tracks, [](const ObjectTrack& track) { return track.superseded; });
}

}  // namespace lanefuse
