// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/pose2.hpp"
#include "objects/object_track.hpp"
#include "objects/road_course.hpp"

namespace lanefuse {

/// Marks the tracks that move across the road. Which way the road goes is what all vehicles' headings agree
/// upon, but for those that differ, beside the curvature of our own way.
class LaneChangeWatch {
 public:
  /// The course of the road by these tracks.
  RoadCourse course(const SightingSet& look, const ObjectTrackerConfig& config,
                    std::span<const ObjectTrack> tracks);

  /// `seconds` since the last look.
  void mark(const SightingSet& look, double seconds, const RoadCourse& course,
            const ObjectTrackerConfig& config, std::span<ObjectTrack> tracks) const;

 private:
  struct Witness {
    double x = 0;        ///< [m] ahead of us
    double heading = 0;  ///< [rad] against our own
    double sigma = 0;    ///< [rad]
  };
  std::vector<Witness> witnesses_;

  static std::optional<Witness> witness(const ObjectTrack& track, const Pose2& vehicle_from_odometry,
                                        double min_speed);
  [[nodiscard]] RoadCourse fitted(const RoadCourse& prior, const RoadCourse& known) const;
};

}  // namespace lanefuse
