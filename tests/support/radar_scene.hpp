// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/pose2.hpp"
#include "sensors/measurement.hpp"

/// A car with a radar among vehicles that drive straight on, and what the radar sees of them.
namespace lanefuse::testing {

inline constexpr double kScanPeriod = 0.05;  ///< [s]
inline Time scan_time(double seconds) { return Time{std::chrono::seconds(1000) + from_seconds(seconds)}; }

struct RoadUser {
  Eigen::Vector2d start;     ///< [m] world frame, at second 0
  Eigen::Vector2d velocity;  ///< [m/s]
  [[nodiscard]] Eigen::Vector2d at(double seconds) const { return start + seconds * velocity; }
};

/// Drives on an arc from the world's origin.
struct RadarCar {
  double speed = 30;
  double yaw_rate = 0.03;
  Pose2 vehicle_from_radar{0, 0, 0};

  [[nodiscard]] Pose2 pose(double seconds) const { return constant_turn(speed, yaw_rate, seconds); }
  [[nodiscard]] Pose2 radar_pose(double seconds) const { return pose(seconds) * vehicle_from_radar; }
  /// By differences of the pose, not by the formula that is to be tested.
  [[nodiscard]] Eigen::Vector2d radar_velocity(double seconds) const {
    constexpr double kStep = 1e-4;
    return (radar_pose(seconds + kStep).position() - radar_pose(seconds - kStep).position()) / (2 * kStep);
  }
  [[nodiscard]] RadarDetection detect(const RoadUser& user, double seconds) const {
    const Eigen::Vector2d in_radar = radar_pose(seconds).inverse() * user.at(seconds);
    const Eigen::Vector2d sight = (user.at(seconds) - radar_pose(seconds).position()).normalized();
    return {in_radar.norm(), std::atan2(in_radar.y(), in_radar.x()),
            sight.dot(user.velocity - radar_velocity(seconds))};
  }
  [[nodiscard]] RadarScan scan(const std::vector<RoadUser>& users, double seconds) const {
    RadarScan result{{scan_time(seconds), scan_time(seconds), 1}, {}};
    for (const RoadUser& user : users) result.detections.push_back(detect(user, seconds));
    return result;
  }
};

/// A radar's noise: the same on every machine.
class RadarNoise {
 public:
  RadarDetection operator()(RadarDetection detection) {
    detection.range += 0.3 * normal();
    detection.bearing += 0.005 * normal();
    detection.range_rate += 0.15 * normal();
    return detection;
  }

 private:
  /// The sum of twelve even numbers is near enough to a normal one.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine_()) / 4294967296.0;
    return sum;
  }
  std::mt19937 engine_{7};
};

}  // namespace lanefuse::testing
