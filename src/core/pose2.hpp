// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace lanefuse {

/// The angle in [-pi, pi) that equals `angle` up to whole turns. Non-finite angles stay as they are.
double wrap_angle(double angle);

/// A pose in the plane, and the transform that takes coordinates of its own frame into its parent's.
///
/// Products chain by their names: `world_from_vehicle * vehicle_from_marking` is `world_from_marking`.
/// Frames follow ISO 8855: x forward, y left, heading counter-clockwise from x. Metres and radians.
struct Pose2 {
  double x = 0;
  double y = 0;
  double heading = 0;

  friend Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c);
  friend Eigen::Vector2d operator*(const Pose2& a_from_b, const Eigen::Vector2d& point_in_b);
  friend bool operator==(const Pose2&, const Pose2&) = default;

  [[nodiscard]] Pose2 inverse() const;
  [[nodiscard]] Eigen::Vector2d position() const { return {x, y}; }
};

/// The rotation by `angle`, for turning vectors and covariances.
Eigen::Matrix2d rotation(double angle);

/// `covariance` of (x, y, heading) with its axes turned by `angle`; the heading's variance stays.
Eigen::Matrix3d rotate_covariance(const Eigen::Matrix3d& covariance, double angle);

/// The pose a vehicle reaches after `seconds` of constant speed [m/s] and yaw rate [rad/s], in its old frame:
/// exact on the arc, and stable at yaw rate zero. [IROS16, sec. II-E1]
Pose2 constant_turn(double speed, double yaw_rate, double seconds);

/// The pose between `from` (fraction 0) and `to` (fraction 1), along the arc of constant turn that joins
/// their headings. Fractions outside [0, 1] extrapolate.
Pose2 interpolate(const Pose2& from, const Pose2& to, double fraction);

}  // namespace lanefuse
