// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/kalman.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

struct RadarTrackerConfig {
  double sigma_range = 0.5;           ///< [m] of a reflection, with its wander over the vehicle's rear
  double sigma_bearing_deg = 0.5;     ///< [deg]
  double sigma_lateral = 0.25;        ///< [m] wander of the reflection across the vehicle's rear
  double sigma_range_rate = 0.25;     ///< [m/s]
  double acceleration_along = 1.5;    ///< [m/s^2 / sqrt(Hz)] process noise along the motion
  double acceleration_across = 0.15;  ///< [m/s^2 / sqrt(Hz)] across it: cars hardly move sideways
  double same_along = 2;              ///< [m] reflections of one scan within these three are one vehicle
  double same_across = 1;             ///< [m]
  double same_range_rate = 1;         ///< [m/s]
  double gate = 16;  ///< squared Mahalanobis distance of a reflection to a track, 3 degrees of freedom
  double start_sigma_across = 0.7;  ///< [m/s] of a new track's speed across the road
  int confirm_hits = 10;            ///< scans before a track counts: half a second at 20 Hz
  double coast_s = 0.5;             ///< [s] a track lives on unseen
  double min_speed = 3;             ///< [m/s] over ground: below, a track stands
  double tentative_coast_s = 0.2;   ///< [s] the same for a track that is not confirmed
};

/// A thin tracker for radars that hand over one reflection a vehicle: nearest neighbour, helped by the
/// radar's own track addresses, and a constant-velocity Kalman filter a track. State (x, y, vx, vy) over
/// ground, in the frame of the dead reckoning, which does not turn with the car.
class RadarTracker {
 public:
  explicit RadarTracker(const RadarTrackerConfig& config) : config_(config) {}

  /// Where the radar was when it took a scan.
  struct Viewpoint {
    Pose2 odometry_from_radar;
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] of the radar over ground, odometry frame
  };

  /// Takes in a scan; scans must come in order of time (an earlier one is refused with false; two radars may
  /// share a stamp). Detections that are no
  /// plausible reflections must have been removed.
  bool update(const RadarScan& scan, const Viewpoint& viewpoint);

  /// The confirmed tracks as they were at the last scan, in the vehicle frame. Camera verification is not
  /// theirs to give.
  [[nodiscard]] std::vector<TrackedObject> tracks(const Pose2& odometry_from_vehicle) const;

  void reset();

 private:
  struct Track {
    std::int64_t id = 0;
    Gaussian<4> state;
    std::optional<std::int32_t> address;
    Time last_seen{};
    int hits = 0;
  };
  struct Reflection;

  void predict(Track& track, double seconds) const;
  [[nodiscard]] Reflection make_reflection(const RadarDetection& detection, const Viewpoint& viewpoint) const;
  [[nodiscard]] bool is_same_vehicle(const Reflection& a, const Reflection& b) const;
  [[nodiscard]] std::vector<Reflection> one_a_vehicle(const RadarScan& scan,
                                                      const Viewpoint& viewpoint) const;
  [[nodiscard]] double distance_squared(const Track& track, const Reflection& reflection) const;
  [[nodiscard]] Track* match(const Reflection& reflection, const std::vector<char>& taken);
  void correct(Track& track, const Reflection& reflection, Time time) const;
  void start(const Reflection& reflection, Time time);
  void forget(Time now);

  const RadarTrackerConfig config_;
  std::vector<Track> tracks_;
  std::optional<Time> last_scan_;
  std::int64_t next_id_ = 1;
};

}  // namespace lanefuse
