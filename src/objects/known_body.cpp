// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/known_body.hpp"

#include <algorithm>
#include <cmath>

#include "objects/track_shape.hpp"

namespace lanefuse {
namespace {

/// [m] by which it may well be longer than supposed.
double length_doubt(const ObjectTrack& track) {
  return 1.5 * std::sqrt(track.state.covariance(kTrackLength, kTrackLength));
}

/// A truck that no camera has seen: where reflections lie behind what was taken for its rear, that was a part
/// of its flank.
void lengthen(ObjectTrack& track, bool backwards) {
  const double more = kTruckLength - track.length();
  if (more <= 0) return;
  const Eigen::Vector2d rear = track.position();
  suppose_length(track, kTruckLength, kTruckLengthSigma);
  if (backwards) {
    const Eigen::Vector2d ahead(std::cos(track.heading), std::sin(track.heading));
    track.state.mean.segment<2>(kTrackX) = rear - more * ahead;
    track.state.covariance.block<2, 2>(kTrackX, kTrackX) +=
        kTruckLengthSigma * kTruckLengthSigma * ahead * ahead.transpose();
  }
  track.width = 2.5;
}

/// Whether what lies `beyond` [m] an end is more of the vehicle.
bool may_be_longer(const ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
                   double beyond) {
  constexpr double kFast = 10;         // [m/s] from which nobody drives so near behind another
  constexpr double kMore = 6;          // [m] at a time
  constexpr double kLongest = 20;      // [m]
  constexpr double kNear = 25;         // [m] to the sensor: further off, places are too uncertain
  constexpr double kWidthKnown = 0.2;  // [m] sigma, below which a camera has told a truck from a car
  return look.kind == SightingKind::radar && track.speed() > kFast && sighting.range < kNear &&
         track.width_sigma > kWidthKnown && beyond < kMore && track.length() + beyond < kLongest;
}

}  // namespace

bool is_on_body(ObjectTrack& track, const SightingSet& look, const Sighting& sighting,
                const ObjectTrackerConfig& config) {
  constexpr double kAround = 1.2;  // [m] about the body
  constexpr int kSurely = 8;       // times
  const double angle = look.odometry_from_sensor.heading + sighting.bearing;
  const Eigen::Vector2d sight(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d place = look.odometry_from_sensor.position() + sighting.range * sight;
  const double doubt = 2 * std::max(sighting.range_sigma, sighting.bearing_sigma * sighting.range);
  const Eigen::Vector2d from_rear = place - track.position();
  const Eigen::Vector2d ahead(std::cos(track.heading), std::sin(track.heading));
  const double along = from_rear.dot(ahead);
  const double across = std::abs(ahead.x() * from_rear.y() - ahead.y() * from_rear.x());
  const double speed = sighting.range_rate ? *sighting.range_rate + look.velocity.dot(sight) : 0;
  const bool as_fast =
      !sighting.range_rate || std::abs(speed - track.velocity().dot(sight)) < 2 * config.same_range_rate;
  if (!as_fast || across > track.width / 2 + kAround + doubt) return false;
  const double length = track.length();
  if (along > -kAround - doubt && along < length + kAround + doubt + length_doubt(track)) return true;
  const double beyond = along < 0 ? -along : along - length;
  if (across > track.width || !may_be_longer(track, look, sighting, beyond)) return false;
  if (++track.longer >= kSurely) {
    track.longer = 0;
    lengthen(track, along < 0);
  }
  return true;
}

}  // namespace lanefuse
