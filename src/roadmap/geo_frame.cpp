// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/geo_frame.hpp"

#include <GeographicLib/Constants.hpp>
#include <numbers>

namespace lanefuse {

GeoFrame::GeoFrame(const GeoOrigin& origin)
    : origin_(origin),
      projection_(GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), 1) {
  double easting = 0;
  projection_.Forward(origin.longitude_deg, origin.latitude_deg, origin.longitude_deg, easting, northing_);
}

Eigen::Vector3d GeoFrame::local(const GeoOrigin& place) const {
  double x = 0;
  double y = 0;
  projection_.Forward(origin_.longitude_deg, place.latitude_deg, place.longitude_deg, x, y);
  return {x, y - northing_, place.height - origin_.height};
}

double GeoFrame::convergence(const GeoOrigin& place) const {
  double x = 0;
  double y = 0;
  double convergence_deg = 0;
  double scale = 0;
  projection_.Forward(origin_.longitude_deg, place.latitude_deg, place.longitude_deg, x, y, convergence_deg,
                      scale);
  return convergence_deg * std::numbers::pi / 180;
}

GeoOrigin GeoFrame::place(const Eigen::Vector3d& local) const {
  GeoOrigin place;
  projection_.Reverse(origin_.longitude_deg, local.x(), local.y() + northing_, place.latitude_deg,
                      place.longitude_deg);
  place.height = local.z() + origin_.height;
  return place;
}

}  // namespace lanefuse
