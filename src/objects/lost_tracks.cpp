// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/lost_tracks.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "objects/track_shape.hpp"

namespace lanefuse {
namespace {

/// Squared Mahalanobis distance of place and velocity.
double distance_squared(const ObjectTrack& a, const ObjectTrack& b) {
  const Eigen::Vector4d apart = a.state.mean.head<4>() - b.state.mean.head<4>();
  const Eigen::Matrix4d doubt =
      a.state.covariance.topLeftCorner<4, 4>() + b.state.covariance.topLeftCorner<4, 4>();
  return apart.dot(doubt.llt().solve(apart));
}

}  // namespace

void LostTracks::add(const ObjectTrack& track) {
  constexpr int kLeastHits = 12;  // looks
  if (track.confirmed && track.has_moved && track.hits >= kLeastHits) tracks_.push_back(track);
}

void LostTracks::know_again(ObjectTrack& young, Time now, const ObjectTrackerConfig& config) {
  constexpr double kYoung = 1.5;  // [s] after which it has made its own name
  if (tracks_.empty() || to_seconds(now - young.born) > kYoung) return;
  constexpr double kOverlap = 0.5;  // [s] for which the old one may have clung to something else
  auto best = tracks_.end();
  double least = config.same_again;
  for (auto lost = tracks_.begin(); lost != tracks_.end(); ++lost) {
    if (to_seconds(lost->last_seen - young.born) > kOverlap) continue;
    const double apart = distance_squared(young, *lost);
    if (apart >= least) continue;
    least = apart;
    best = lost;
  }
  if (best == tracks_.end()) return;
  young.id = best->id;
  young.born = best->born;
  young.has_moved = true;
  young.width = best->width;
  young.width_sigma = best->width_sigma;
  suppose_length(young, best->length(), std::sqrt(best->state.covariance(kTrackLength, kTrackLength)));
  tracks_.erase(best);
}

void LostTracks::forget(Time now, const ObjectTrackerConfig& config) {
  std::erase_if(tracks_,
                [&](const ObjectTrack& track) { return to_seconds(now - track.last_seen) > config.lost_s; });
}

}  // namespace lanefuse
