// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lanefuse {

/// Where a local frame lies on Earth (WGS 84): its origin, x to the east, y to the north, z up.
struct GeoOrigin {
  double latitude_deg = 0;   ///< [-90, 90]
  double longitude_deg = 0;  ///< [-180, 180]
  double height = 0;         ///< [m] above the ellipsoid
  friend bool operator==(const GeoOrigin&, const GeoOrigin&) = default;
};

}  // namespace lanefuse
