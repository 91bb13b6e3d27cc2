// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "core/kalman.hpp"
#include "core/time.hpp"
#include "objects/object_tracker_config.hpp"
#include "objects/sighting.hpp"

namespace lanefuse {

/// What a track's filter carries: the middle of the vehicle's rear and its velocity over ground, in the frame
/// of the dead reckoning, which does not turn with the car; how far across the rear the point lies that
/// radars see; and the vehicle's length, which ties the front to the rear.
enum TrackState : int { kTrackX, kTrackY, kTrackVx, kTrackVy, kTrackWander, kTrackLength, kTrackStateSize };

/// Evidence that one kind of sensor gives for a track: log odds, raised by looks that see it, lowered by
/// looks that should.
struct Verification {
  double odds = 0;
  bool verified = false;
  std::optional<Time> last = {};  ///< when it was seen

  void add(double evidence, const ObjectTrackerConfig& config);
};

struct ObjectTrack {
  std::int64_t id = 0;
  Gaussian<kTrackStateSize> state;
  double heading = 0;        ///< [rad] in the odometry frame; of its motion while it moved last
  double width = 1.8;        ///< [m]
  double width_sigma = 0.3;  ///< [m]
  int longer = 0;            ///< reflections of late that say it is longer
  double odds = 0;           ///< log odds that it exists
  int hits = 0;              ///< looks in which it was seen
  int run = 0;               ///< of those, since it was out of sight for a while
  bool confirmed = false;
  Time confirmed_at{};
  bool has_moved = false;   ///< has been seen driving: what stands then is a vehicle that stopped
  bool refused = false;     ///< a mirror image, or nothing where a camera should see a vehicle
  bool superseded = false;  ///< an older track follows the same vehicle
  Time born{};              ///< when it was seen first
  Time last_seen{};
  Time last_due{};  ///< the last look in which it should have been seen, or was
  Verification radar;
  Verification camera;
  std::optional<std::int32_t> address = {};  ///< in the tracking radar that saw it last
  double across_s = 0;                       ///< [s] for which it has been moving across the road
  bool changing_lane = false;

  [[nodiscard]] Eigen::Vector2d position() const { return state.mean.segment<2>(kTrackX); }
  [[nodiscard]] Eigen::Vector2d velocity() const { return state.mean.segment<2>(kTrackVx); }
  [[nodiscard]] double speed() const { return velocity().norm(); }
  [[nodiscard]] double length() const { return std::clamp(state.mean[kTrackLength], 3.0, 20.0); }  ///< [m]
};

/// What a sighting tells of a track, linearised: the place over ground and, of a radar, the speed along the
/// line of sight.
struct TrackObservation {
  static constexpr int kSize = 3;
  Eigen::Vector3d residual;  ///< measured minus expected: x, y, speed
  Eigen::Matrix3d noise;
  Eigen::Matrix<double, kSize, kTrackStateSize> jacobian;
};

/// Where a new track starts: from one sighting, driving as we do where nothing is known of its motion.
ObjectTrack start_track(const SightingSet& look, const Sighting& sighting, const ObjectTrackerConfig& config,
                        double own_heading);

/// Moves on with the road, whose `curvature` [1/m] is what drivers follow.
void predict(ObjectTrack& track, double seconds, const Eigen::Vector2d& own_position, double curvature,
             const ObjectTrackerConfig& config);

/// The vehicle's face that the sensor sees decides which of its points is seen: the rear from behind, the
/// front from ahead, anywhere along it from beside.
TrackObservation observe(const ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
                         const ObjectTrackerConfig& config);

/// How badly the sighting fits: squared Mahalanobis distance and, for comparing tracks, the log of the
/// innovation's determinant beside it.
struct Misfit {
  double distance_squared = 0;
  double log_volume = 0;
};
Misfit misfit(const ObjectTrack& track, const TrackObservation& observation);

void update(ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
            const ObjectTrackerConfig& config);

}  // namespace lanefuse
