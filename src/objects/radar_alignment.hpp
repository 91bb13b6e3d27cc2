// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/kalman.hpp"
#include "core/time.hpp"
#include "objects/passed_thing.hpp"
#include "objects/sighting.hpp"

namespace lanefuse {

struct RadarAlignmentConfig {
  bool enabled = true;
  double sigma_deg = 0.1;              ///< [deg] of a mounting, before anything is known
  double drift_deg = 0.001;            ///< [deg/sqrt(s)] by which mountings settle
  double most_deg = 1;                 ///< [deg] more is never corrected: that is for a workshop
  double yaw_rate_sigma_deg = 0.05;    ///< [deg/s] that the yaw rate is off by
  double yaw_rate_drift_deg = 0.0005;  ///< [deg/s/sqrt(s)] by which that changes
};

/// By how much radars are turned against what the rig says: a fraction of a degree that shifts all that they
/// see to one side, and that no filter averages out. Things that stand tell: approached, they come straight
/// on, and drift to one side by that angle for each metre where the radar is turned. A gyro's bias makes them
/// drift, too, but the more the further away they are: both are estimated, a Kalman filter a radar. Angles
/// are about the direction in which the dead reckoning says that the car moves.
class RadarAlignment {
 public:
  struct Offset {
    double value = 0;  ///< [rad] by how much bearings are too large, bounded
    double sigma = 0;  ///< [rad]
  };

  explicit RadarAlignment(const RadarAlignmentConfig& config) : config_(config) {}

  /// Learns from a look of a radar, as it was measured; others, and late ones, tell nothing.
  void look(const SightingSet& look);

  /// Takes what is known off the bearings of a look.
  void correct(SightingSet& look) const;

  /// Zero, with the first sigma, of what was never heard of.
  [[nodiscard]] Offset offset_of(std::uint32_t sensor_id) const;

  /// The dead reckoning began anew: what stood in its old frame is nowhere in the new one.
  void lose_things();
  void reset() { radars_.clear(); }

 private:
  struct Radar {
    std::uint32_t id = 0;
    Time last_look{};
    Gaussian<kRadarTurnSize> turn;
    std::vector<PassedThing> things;
  };

  RadarAlignmentConfig config_;
  std::vector<Radar> radars_;  ///< in the order of their first looks

  Radar& radar_of(const SightingSet& look);
  void pass_time(Radar& radar, const SightingSet& look) const;
};

}  // namespace lanefuse
