// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/geo_frame.hpp"

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// East and north of a place, as they lie in the plane.
struct Directions {
  Eigen::Vector2d east;
  Eigen::Vector2d north;
};

Directions directions(const std::vector<double>& plane_from_place) {
  return {{plane_from_place[0], plane_from_place[3]}, {plane_from_place[1], plane_from_place[4]}};
}

}  // namespace

GeoFrame::GeoFrame(const GeoOrigin& origin)
    : origin_height_(origin.height),
      plane_(std::make_shared<GeographicLib::LocalCartesian>(origin.latitude_deg, origin.longitude_deg,
                                                             origin.height)) {}

GeoFrame::Place GeoFrame::place(const OnEarth& there) const {
  double x = 0;
  double y = 0;
  double z = 0;
  std::vector<double> plane_from_place(9);
  plane_->Forward(there.latitude / kDegree, there.longitude / kDegree, there.height, x, y, z,
                  plane_from_place);
  const auto [east, north] = directions(plane_from_place);
  const Eigen::Vector2d ahead = std::cos(there.heading) * east + std::sin(there.heading) * north;
  return {{x, y, std::atan2(ahead.y(), ahead.x())}, there.height - origin_height_};
}

GeoFrame::OnEarth GeoFrame::on_earth(const Place& place) const {
  const auto& [x, y, plane_heading] = place.pose;
  double latitude = 0;
  double longitude = 0;
  double height = 0;
  double z = 0;
  std::vector<double> plane_from_place(9);
  // The height is wanted over the ellipsoid, not over the plane; up is nearly z, so each round gains decades.
  for (int round = 0; round < 4; ++round) {
    plane_->Reverse(x, y, z, latitude, longitude, height, plane_from_place);
    z += origin_height_ + place.height - height;
  }
  const auto [east, north] = directions(plane_from_place);
  const Eigen::Vector2d ahead(std::cos(plane_heading), std::sin(plane_heading));
  return {latitude * kDegree, longitude * kDegree, origin_height_ + place.height,
          std::atan2(ahead.dot(north), ahead.dot(east))};
}

}  // namespace lanefuse
