// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace lanefuse {

/// A clothoid as the cubic of [IROS16, eq. 11], in the vehicle frame:
///     y(x) = y0 + theta0 x + c0 x^2 / 2 + c1 x^3 / 6.
/// Good for headings up to 15 degrees. Other conventions (Apollo's, Mobileye's plain coefficients, degrees a
/// metre) are converted where they come in.
struct Clothoid {
  double lateral_offset = 0;  ///< y0 [m], positive to the left
  double heading = 0;         ///< theta0 [rad]: the slope at x = 0
  double curvature = 0;       ///< c0 [1/m], positive to the left
  double curvature_rate = 0;  ///< c1 [1/m^2]

  [[nodiscard]] double y(double x) const {
    return lateral_offset + x * (heading + x * (curvature / 2 + x * curvature_rate / 6));
  }
  /// dy/dx: the tangent of the heading.
  [[nodiscard]] double slope(double x) const { return heading + x * (curvature + x * curvature_rate / 2); }
  [[nodiscard]] double heading_at(double x) const;
  [[nodiscard]] double curvature_at(double x) const { return curvature + x * curvature_rate; }

  [[nodiscard]] Eigen::Vector4d vector() const {
    return {lateral_offset, heading, curvature, curvature_rate};
  }
  static Clothoid from_vector(const Eigen::Vector4d& v) { return {v[0], v[1], v[2], v[3]}; }

  friend bool operator==(const Clothoid&, const Clothoid&) = default;
};

/// How y(x) changes with (y0, theta0, c0, c1): the row that maps a clothoid's covariance to a lateral
/// variance.
Eigen::RowVector4d lateral_jacobian(double x);

/// How the slope at x changes with (y0, theta0, c0, c1).
Eigen::RowVector4d slope_jacobian(double x);

/// The same curve seen from a frame that has moved by `old_from_new`; exact up to the cubic's own
/// approximation (headings to 15 degrees): offset and slope are taken where the new y axis cuts the curve.
Clothoid transform(const Clothoid& in_old, const struct Pose2& old_from_new);

}  // namespace lanefuse
