// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "core/time.hpp"

namespace lanefuse {

enum class SightingKind : std::uint8_t { radar = 0, camera = 1 };

/// What one sensor says of one thing in one look, in polar terms about the sensor: all that the tracker knows
/// of sensors.
struct Sighting {
  double range = 0;          ///< [m] > 0, over the ground
  double bearing = 0;        ///< [rad] from the sensor's x axis, counter-clockwise
  double range_sigma = 1;    ///< [m]
  double bearing_sigma = 1;  ///< [rad]
  /// [m/s] along the line of sight, positive away, as measured: the sensor's own motion is in it.
  std::optional<double> range_rate = {};
  double range_rate_sigma = 0.1;  ///< [m/s]
  /// [rad] that it spans, where the sensor sees both of its sides.
  std::optional<double> angular_width = {};
  double angular_width_sigma = 0.003;  ///< [rad]
  double confidence = 1;               ///< in [0, 1]
  /// Some radars track inside: the slot that this was filed under, unless the slot was just taken anew.
  std::optional<std::int32_t> address = {};
};

/// How far and how well a sensor sees.
struct SensorField {
  double range = 200;          ///< [m]
  double half_angle = 3;       ///< [rad] to either side of its x axis
  double near_range = 0;       ///< [m] up to which its field is wider
  double near_half_angle = 3;  ///< [rad]
  double detection = 0.9;      ///< probability that it reports a vehicle in its field
  double detection_far = 0.9;  ///< the same at `range`; in between it falls linearly

  [[nodiscard]] bool contains(double at_range, double bearing) const {
    return at_range < range && std::abs(bearing) < (at_range < near_range ? near_half_angle : half_angle);
  }
  [[nodiscard]] double detection_at(double at_range) const {
    return detection + (detection_far - detection) * std::clamp(at_range / range, 0.0, 1.0);
  }
};

/// One look of one sensor.
struct SightingSet {
  Time measured_at{};
  std::uint32_t sensor_id = 0;
  SightingKind kind = SightingKind::radar;
  Pose2 odometry_from_sensor;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] of the sensor over ground, odometry frame
  Pose2 odometry_from_vehicle;
  double own_curvature = 0;  ///< [1/m] of our own way
  SensorField field;
  std::vector<Sighting> sightings;
};

}  // namespace lanefuse
