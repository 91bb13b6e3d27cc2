// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/pose2.hpp"
#include "core/time.hpp"

namespace lanefuse {

/// The car's own motion at one instant: the control vector u = [yaw rate, speed] of [IROS16, sec. II-E1], and
/// the pose that integrating it has led to.
struct MotionSample {
  Time time{};
  /// Dead-reckoned pose in a frame that starts anywhere and drifts: only differences between samples mean
  /// anything.
  Pose2 odometry_from_vehicle;
  double speed = 0;     ///< [m/s] forward at the origin
  double yaw_rate = 0;  ///< [rad/s], counter-clockwise, bias removed as far as it is known
};

/// Uncertainty of the odometry, for the information of the odometry edges.
struct OdometryNoise {
  double speed_scale = 0.01;    ///< relative error of the speed, constant over a window
  double yaw_rate_white = 0.1;  ///< white noise density of the yaw rate [deg/s at 1 Hz bandwidth]
  double yaw_rate_bias = 0.05;  ///< what is left of the yaw rate's bias [deg/s]
  double slip = 0.002;          ///< sideways slip a metre driven [m/m]
};

/// The dead-reckoned pose at `time`, on the arc between the samples around it; beyond the ends at most
/// `reach` is extrapolated with the end's speed and yaw rate. `samples` are in order of time and not empty.
/// Returns false if `time` lies further out.
bool pose_at(std::span<const MotionSample> samples, Time time, Duration reach, Pose2& odometry_from_vehicle);

}  // namespace lanefuse
