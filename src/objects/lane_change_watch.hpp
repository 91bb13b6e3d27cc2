// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/pose2.hpp"
#include "objects/object_track.hpp"

namespace lanefuse {

/// Marks the tracks that move across the road. Which way the road goes ahead is what all vehicles' headings
/// agree upon, but for those that differ: a line of headings, curvature and its change along the way, from
/// our own place and heading on.
class LaneChangeWatch {
 public:
  /// `seconds` since the last call.
  void look(const SightingSet& look, double seconds, const ObjectTrackerConfig& config,
            std::span<ObjectTrack> tracks);

 private:
  struct Witness {
    double x = 0;        ///< [m] ahead of us
    double heading = 0;  ///< [rad] against our own
    double sigma = 0;    ///< [rad]
  };
  std::vector<Witness> witnesses_;

  static std::optional<Witness> witness(const ObjectTrack& track, const Pose2& vehicle_from_odometry,
                                        double min_speed);
  [[nodiscard]] Gaussian<3> course(double own_curvature) const;
};

}  // namespace lanefuse
