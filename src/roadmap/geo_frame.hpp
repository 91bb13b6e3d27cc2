// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <GeographicLib/TransverseMercator.hpp>

#include <Eigen/Core>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// Converts between a map's local frame and places on Earth: the transverse Mercator projection through the
/// origin, true to scale there (1.2 cm too long over 10 km at 10 km from it), heights above the ellipsoid.
class GeoFrame {
 public:
  explicit GeoFrame(const GeoOrigin& origin);

  /// [m] in the local frame.
  [[nodiscard]] Eigen::Vector3d local(const GeoOrigin& place) const;
  [[nodiscard]] GeoOrigin place(const Eigen::Vector3d& local) const;
  /// [rad] by which a heading in the local frame exceeds the same one counted from the east of that place:
  /// meridians meet at the poles.
  [[nodiscard]] double convergence(const GeoOrigin& place) const;

 private:
  GeoOrigin origin_;
  GeographicLib::TransverseMercator projection_;
  double northing_ = 0;  ///< [m] of the origin
};

}  // namespace lanefuse
