// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace lanefuse {

/// A plane that touches the WGS 84 ellipsoid: x east, y north, z up. Takes earth-centred, earth-fixed (ECEF)
/// coordinates in metres to metres in the plane. Over a few kilometres the earth's curvature may be
/// neglected.
class LocalPlane {
 public:
  /// `origin_ecef`, which need not lie on the ellipsoid, becomes (0, 0, 0).
  explicit LocalPlane(const Eigen::Vector3d& origin_ecef);

  [[nodiscard]] Eigen::Vector3d position(const Eigen::Vector3d& ecef) const {
    return direction(ecef - origin_);
  }
  [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& ecef) const {
    return plane_from_ecef_ * ecef;
  }

 private:
  Eigen::Vector3d origin_;
  Eigen::Matrix3d plane_from_ecef_;
};

/// The geodetic latitude [rad] of a point near the earth's surface.
double geodetic_latitude(const Eigen::Vector3d& ecef);

}  // namespace lanefuse
