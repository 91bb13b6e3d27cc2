// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "objects/object_track.hpp"
#include "objects/object_tracker_config.hpp"

namespace lanefuse {

/// Vehicles whose tracks came to their end while others hid them, or where sensors see badly. Their places
/// are carried on, so that a new track where one of them must be by now is known for the same vehicle.
class LostTracks {
 public:
  /// Remembers the track, if it was one of a vehicle and not of something that came and went.
  void add(const ObjectTrack& track);

  [[nodiscard]] std::span<ObjectTrack> tracks() { return tracks_; }

  /// Looks for the vehicle that this new track goes on from, among those lost and those of `tracks` that have
  /// been out of sight for a while. Where there is one, the new track takes its name, and the old one is
  /// superseded.
  void know_again(ObjectTrack& young, Time now, std::span<ObjectTrack> tracks,
                  const ObjectTrackerConfig& config);

  void forget(Time now, const ObjectTrackerConfig& config);
  void clear() { tracks_.clear(); }

 private:
  std::vector<ObjectTrack> tracks_;
};

}  // namespace lanefuse
