// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "roadmap/road_map.hpp"
#include "roadmap/survey_drive.hpp"

namespace lanefuse {

/// What errs, and how slowly, when markings are laid over a map: all of it wanders about zero.
struct LocaliserConfig {
  double position_sigma = 0.025;  ///< [m] of the track, across
  double position_tau = 60;       ///< [s]
  double heading_sigma = 0.0009;  ///< [rad] of the track
  double heading_tau = 60;        ///< [s]
  double yaw_sigma = 0.0021;      ///< [rad] of the camera's calibration
  double yaw_tau = 120;           ///< [s]
  double sight_sigma = 0.15;      ///< [m] of one marking in one frame; large, as frames err alike
};

/// Where the car is in a map at one moment.
struct MapPose {
  Time time{};
  Pose2 by_fixes;                       ///< of the track alone, in the map's frame
  Pose2 by_map;                         ///< corrected by the markings
  std::optional<std::uint64_t> lane;    ///< the map's lane that the car is in
  int lane_number = 0;                  ///< of that lane, 1 is the leftmost; 0: in none
  double sigma = 0;                     ///< [m] of the corrected position, across
  std::optional<double> left_residual;  ///< [m] of the newest left marking against the map, before correction
  std::optional<double> right_residual;
};

/// Places a drive in a map at `times`, which are in order: its track, corrected across and in heading by the
/// markings that its serial camera saw until then. Times outside the track are left out.
std::vector<MapPose> localise(const SurveyedDrive& drive, const RoadMap& map, std::span<const Time> times,
                              const LocaliserConfig& config = {});

}  // namespace lanefuse
