// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/local_plane.hpp"

#include <cmath>

namespace lanefuse {
namespace {

// WGS 84
constexpr double kEquatorialRadius = 6378137.0;  // [m]
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kEccentricitySquared = kFlattening * (2 - kFlattening);

}  // namespace

double geodetic_latitude(const Eigen::Vector3d& ecef) {
  const double from_axis = std::hypot(ecef.x(), ecef.y());
  double latitude = std::atan2(ecef.z(), from_axis * (1 - kEccentricitySquared));
  // Each round gains more than two digits near the surface; four reach a double's precision.
  for (int round = 0; round < 6; ++round) {
    const double sine = std::sin(latitude);
    const double curvature_radius = kEquatorialRadius / std::sqrt(1 - kEccentricitySquared * sine * sine);
    latitude = std::atan2(ecef.z() + kEccentricitySquared * curvature_radius * sine, from_axis);
  }
  return latitude;
}

LocalPlane::LocalPlane(const Eigen::Vector3d& origin_ecef) : origin_(origin_ecef) {
  const double latitude = geodetic_latitude(origin_ecef);
  const double longitude = std::atan2(origin_ecef.y(), origin_ecef.x());
  const Eigen::Vector3d up(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                           std::sin(latitude));
  const Eigen::Vector3d east(-std::sin(longitude), std::cos(longitude), 0);
  plane_from_ecef_ << east.transpose(), up.cross(east).transpose(), up.transpose();
}

}  // namespace lanefuse
