// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/lost_tracks.hpp"

#include "objects/track_relations.hpp"

namespace lanefuse {

void LostTracks::add(const ObjectTrack& track) {
  if (track.confirmed && track.has_moved) tracks_.push_back(track);
}

void LostTracks::know_again(ObjectTrack& young, Time now, std::span<ObjectTrack> tracks,
                            const ObjectTrackerConfig& config) {
  constexpr double kYoung = 1.5;    // [s] after which it has made its own name
  constexpr double kOverlap = 0.5;  // [s] for which the old one may have clung to something else
  if (to_seconds(now - young.born) > kYoung) return;
  ObjectTrack* best = nullptr;
  double least = config.same_again;
  const auto consider = [&](ObjectTrack& gone) {
    double apart = 0;
    const bool overlap = to_seconds(gone.last_seen - young.born) > kOverlap;
    if (overlap || !may_be_same(young, gone, least, apart)) return;
    least = apart;
    best = &gone;
  };
  for (ObjectTrack& gone : tracks_) consider(gone);
  for (ObjectTrack& hidden : tracks) {
    const bool unseen = to_seconds(now - hidden.last_seen) > config.gap_s;
    if (&hidden != &young && hidden.confirmed && !hidden.superseded && unseen) consider(hidden);
  }
  if (!best) return;
  take_name(young, *best);
  best->superseded = true;
  std::erase_if(tracks_, [](const ObjectTrack& track) { return track.superseded; });
}

void LostTracks::forget(Time now, const ObjectTrackerConfig& config) {
  std::erase_if(tracks_,
                [&](const ObjectTrack& track) { return to_seconds(now - track.last_seen) > config.lost_s; });
}

}  // namespace lanefuse
