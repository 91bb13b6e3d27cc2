// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/pose2.hpp"
#include "sensors/geo_origin.hpp"

namespace GeographicLib {
class LocalCartesian;
}

namespace lanefuse {

/// A plane that touches the ellipsoid (WGS 84) under an origin, x to the east and y to the north *there*, and
/// the one way between it and latitude and longitude. Away from the origin, east turns against x (meridians
/// meet at the pole) and the ground falls below the plane: both are accounted for.
class GeoFrame {
 public:
  struct Place {
    Pose2 pose;
    double height = 0;  ///< [m] above the ellipsoid, over the origin's
  };
  struct OnEarth {
    double latitude = 0;   ///< [rad]
    double longitude = 0;  ///< [rad]
    double height = 0;     ///< [m] above the ellipsoid
    double heading = 0;    ///< [rad] counter-clockwise from the east of that place
  };

  explicit GeoFrame(const GeoOrigin& origin);
  [[nodiscard]] Place place(const OnEarth& there) const;
  [[nodiscard]] OnEarth on_earth(const Place& place) const;

 private:
  double origin_height_;
  std::shared_ptr<const GeographicLib::LocalCartesian> plane_;
};

}  // namespace lanefuse
