// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "core/kalman.hpp"

namespace lanefuse {

/// Which way the road goes around us, as the traffic on it agrees: heading [rad] against our own, curvature
/// [1/m] at our place and its change along the way [1/m^2], in the vehicle frame.
struct RoadCourse {
  Gaussian<3> line;

  struct Estimate {
    double value = 0;
    double sigma = 0;
  };
  /// [rad] at x ahead.
  [[nodiscard]] Estimate heading(double x) const { return at({1, x, x * x / 2}); }
  /// [1/m] at x ahead.
  [[nodiscard]] double curvature(double x) const { return line.mean[1] + x * line.mean[2]; }
  /// [m] across the course, of a place in the vehicle frame.
  [[nodiscard]] Estimate offset(const Eigen::Vector2d& place) const {
    const double x = place.x();
    const Estimate centre = at({x, x * x / 2, x * x * x / 6});
    return {place.y() - centre.value, centre.sigma};
  }

 private:
  [[nodiscard]] Estimate at(const Eigen::RowVector3d& row) const {
    return {row.dot(line.mean), std::sqrt((row * line.covariance * row.transpose()).value())};
  }
};

}  // namespace lanefuse
