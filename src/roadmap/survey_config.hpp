// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lanefuse {

/// How a road is surveyed from drives; docs/survey.md says why each number is what it is.
struct SurveyConfig {
  double fix_period = 0.1;      ///< [s] between the fixes that are kept: their errors wander far more slowly
  double station_step = 2;      ///< [m] between the points of the map's lines
  double smoothing_reach = 12;  ///< [m] to either side, of the curve that is fitted through a line's points
  double yaw_reach = 250;       ///< [m] to either side, over which a camera's yaw error is taken as one
  double drift_reach = 150;     ///< [m] to either side, over which a drive's position error is taken as one
  double drift_sigma = 0.02;    ///< [m] of a drive's position error across the road
  double marking_sigma = 0.01;  ///< [m] of a drive's marking over `drift_reach`
  double longest_gap = 40;      ///< [m] that a line is carried over without having been seen
  double shortest_line = 40;    ///< [m]
  double narrowest_lane = 2.5;  ///< [m]
  double widest_lane = 4.75;    ///< [m]
  double lane_line_width = 0.15;  ///< [m] of dashed paint that is seen from one side only
  double edge_line_width = 0.30;  ///< [m] of solid paint that is seen from one side only
};

}  // namespace lanefuse
