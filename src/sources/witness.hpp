// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/feature.hpp"
#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// How another vehicle bears witness of its lane [IROS16, secs. II-C, II-E4].
struct WitnessConfig {
  WitnessRule rule = WitnessRule::radar_and_camera;
  double driver_sigma = 0.3;        ///< [m] of drivers about the middle of their lane
  double driver_heading_deg = 0.7;  ///< [deg]
  double confidence = 0.35;         ///< c_m of each feature
  double min_speed = 3;             ///< [m/s] slower vehicles may stand anywhere
  double max_heading_deg = 15;      ///< [deg] turned further, a vehicle does not follow the road
  double range_begin = 2;           ///< [m] ahead of the front axle
  double range_max = 150;           ///< [m]
  LaneWidth default_width;          ///< where no camera measures the lane
};

/// Whether a tracked vehicle may bear witness: driving, ahead, in our direction, and verified as the rule
/// demands.
bool is_witness(const TrackedObject& object, const WitnessConfig& config);

/// Appends the two features of a witness: left and right of it, half a lane's width away, perpendicular to
/// its heading. Their covariance is the object's plus the drivers' spread.
void add_witness_features(const TrackedObject& object, const LaneWidth& width, const WitnessConfig& config,
                          std::vector<Feature>& features);

}  // namespace lanefuse
