// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clothoid.hpp"

#include <cmath>

#include "core/pose2.hpp"

namespace lanefuse {

double Clothoid::heading_at(double x) const { return std::atan(slope(x)); }

Eigen::RowVector4d lateral_jacobian(double x) { return {1, x, x * x / 2, x * x * x / 6}; }

Eigen::RowVector4d slope_jacobian(double x) { return {0, 1, x, x * x / 2}; }

Clothoid transform(const Clothoid& in_old, const Pose2& old_from_new) {
  // Walk along the new y axis until it meets the curve; one Newton step is exact to second order in the small
  // heading.
  const double c = std::cos(old_from_new.heading);
  const double s = std::sin(old_from_new.heading);
  double offset = 0;
  for (int i = 0; i < 3; ++i) {
    const double x = old_from_new.x - s * offset;
    const double y = old_from_new.y + c * offset;
    offset += (in_old.y(x) - y) / (c + s * in_old.slope(x));
  }
  const double x = old_from_new.x - s * offset;
  const double heading = wrap_angle(in_old.heading_at(x) - old_from_new.heading);
  return {offset, std::tan(heading), in_old.curvature_at(x), in_old.curvature_rate};
}

}  // namespace lanefuse
