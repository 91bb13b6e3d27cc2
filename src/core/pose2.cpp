// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/pose2.hpp"

#include <cmath>
#include <numbers>

namespace lanefuse {

double wrap_angle(double angle) {
  constexpr double kPi = std::numbers::pi;
  if (angle >= -kPi && angle < kPi) return angle;
  if (!std::isfinite(angle)) return angle;
  const double wrapped = std::remainder(angle, 2 * kPi);
  return wrapped >= kPi ? wrapped - 2 * kPi : wrapped;
}

Pose2 operator*(const Pose2& a, const Pose2& b) {
  const double c = std::cos(a.heading);
  const double s = std::sin(a.heading);
  return {a.x + c * b.x - s * b.y, a.y + s * b.x + c * b.y, wrap_angle(a.heading + b.heading)};
}

Eigen::Vector2d operator*(const Pose2& a, const Eigen::Vector2d& p) {
  const double c = std::cos(a.heading);
  const double s = std::sin(a.heading);
  return {a.x + c * p.x() - s * p.y(), a.y + s * p.x() + c * p.y()};
}

Pose2 Pose2::inverse() const {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  return {-c * x - s * y, s * x - c * y, wrap_angle(-heading)};
}

Eigen::Matrix2d rotation(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

Eigen::Matrix3d rotate_covariance(const Eigen::Matrix3d& covariance, double angle) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = rotation(angle);
  return turn * covariance * turn.transpose();
}

Pose2 constant_turn(double speed, double yaw_rate, double seconds) {
  const double turn = yaw_rate * seconds;
  const double distance = speed * seconds;
  // The chord of the arc: sinc keeps it exact for large turns and defined for none.
  const double half = 0.5 * turn;
  const double sinc = std::abs(half) < 1e-6 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
  return {distance * sinc * std::cos(half), distance * sinc * std::sin(half), wrap_angle(turn)};
}

Pose2 interpolate(const Pose2& from, const Pose2& to, double fraction) {
  const Pose2 step = from.inverse() * to;
  // The twist (forward, sideways, turn) that leads from the one to the other in unit time: v = V(turn)^-1 *
  // step.
  const double half = 0.5 * step.heading;
  const double cotangent = std::abs(half) < 1e-6 ? 1.0 - half * half / 3.0 : half / std::tan(half);
  const double forward = cotangent * step.x + half * step.y;
  const double sideways = -half * step.x + cotangent * step.y;
  const Pose2 along = constant_turn(1.0, step.heading, fraction);
  const Pose2 moved{along.x * forward - along.y * sideways, along.y * forward + along.x * sideways,
                    along.heading};
  return from * moved;
}

}  // namespace lanefuse
