// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "objects/object_track.hpp"

namespace lanefuse {

/// Which tracks a sensor should see in a look: those in its field that no nearer one hides.
class TrackSight {
 public:
  void look(const SightingSet& look, std::span<const ObjectTrack> tracks);

  /// Probability that the sensor reports the track, if it exists; 0 outside of its field and behind others.
  [[nodiscard]] double detection(std::size_t track) const { return views_[track].detection; }

 private:
  struct View {
    double range = 0;
    double bearing = 0;
    double left = 0;     ///< [rad] from its bearing to its left side, along its whole body
    double right = 0;    ///< [rad] to its right side, a negative number
    double quarter = 0;  ///< [rad] of its width
    double detection = 0;
  };
  std::vector<View> views_;

  static void measure_body(const ObjectTrack& track, const Pose2& sensor_from_odometry, View& view);
  [[nodiscard]] bool hidden(std::size_t track, std::span<const ObjectTrack> tracks) const;
};

}  // namespace lanefuse
