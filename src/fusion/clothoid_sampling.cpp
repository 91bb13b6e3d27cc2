// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/clothoid_sampling.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kConfidenceRange = 60;  ///< [m] over which a serial camera's confidence falls to 1/e
constexpr double kSigmaFloor = 0.03;     ///< [m] no camera calibration is better
constexpr double kHeadingFloor = 0.003;  ///< [rad]

}  // namespace

void sample_clothoid(const ClothoidMeasurement& measurement, double spacing, std::vector<Feature>& features) {
  assert(spacing > 0);
  for (double x = measurement.range_begin; x <= measurement.range_end; x += spacing) {
    const double slope = measurement.clothoid.slope(x);
    const double lateral = lateral_jacobian(x) * measurement.covariance * lateral_jacobian(x).transpose();
    // d atan(slope) = d slope / (1 + slope^2)
    const double turn = 1 / (1 + slope * slope);
    const double heading = slope_jacobian(x) * measurement.covariance * slope_jacobian(x).transpose();
    Feature feature;
    feature.x = x;
    feature.y = measurement.clothoid.y(x);
    feature.heading = std::atan(slope);
    feature.confidence = measurement.confidence * std::exp(-std::max(0.0, x) / kConfidenceRange);
    feature.covariance = Eigen::Vector3d(spacing * spacing / 4, lateral + kSigmaFloor * kSigmaFloor,
                                         turn * turn * heading + kHeadingFloor * kHeadingFloor)
                             .asDiagonal();
    feature.marking = measurement.marking;
    features.push_back(feature);
  }
}

}  // namespace lanefuse
