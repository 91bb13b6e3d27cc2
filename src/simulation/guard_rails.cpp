// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/guard_rails.hpp"

#include <cmath>
#include <numbers>

namespace lanefuse {

std::optional<GuardRail> RoadRails::beside(const Scene& scene, const PlaceOnRoad& place, int side) const {
  if (!scene.road) return {};
  const double lateral = scene.road->guard_rail(side, place.station);
  return GuardRail{scene.road->pose(place.station, lateral), scene.road->curvature(place.station, lateral)};
}

BoundaryRails::BoundaryRails(const TrueRoad& road, double beyond) : beyond_(beyond) {
  for (const TrueBoundary& boundary : road.boundaries) {
    for (std::size_t i = 1; i < boundary.points.size(); ++i) {
      pieces_.push_back({boundary.points[i - 1], boundary.points[i]});
    }
  }
}

std::optional<GuardRail> BoundaryRails::beside(const Scene& /*scene*/, const PlaceOnRoad& place,
                                               int side) const {
  const Pose2 place_from_world = place.world_from_place.inverse();
  double outermost = 0;
  std::optional<GuardRail> rail;
  for (const Piece& piece : pieces_) {
    const Eigen::Vector2d from = place_from_world * piece.from;
    const Eigen::Vector2d to = place_from_world * piece.to;
    if ((from.x() > 0) == (to.x() > 0)) continue;
    const double y = from.y() + (to.y() - from.y()) * from.x() / (from.x() - to.x());
    if (side * y <= outermost) continue;
    outermost = side * y;
    const Eigen::Vector2d along = from.x() < to.x() ? to - from : from - to;
    const Pose2 boundary{0, y, std::atan2(along.y(), along.x())};
    rail = GuardRail{place.world_from_place * boundary * Pose2{0, side * beyond_, 0}};
  }
  return rail;
}

/// Its heading turns the other way against the rail; and beside a bent rail it goes a way of another length
/// in the same time, as its range tells the radar.
SceneVehicle mirrored(const SceneVehicle& vehicle, const GuardRail& rail) {
  const Pose2 rail_from_vehicle = rail.world_from_rail.inverse() * vehicle.world_from_vehicle;
  const double bend = rail.curvature * rail_from_vehicle.y;
  const double along_rail = vehicle.speed * std::cos(rail_from_vehicle.heading) / (1 - bend);
  SceneVehicle image = vehicle;
  image.world_from_vehicle =
      rail.world_from_rail * Pose2{rail_from_vehicle.x, -rail_from_vehicle.y, -rail_from_vehicle.heading};
  image.speed = vehicle.speed * (1 + bend) / (1 - bend);
  image.yaw_rate = 2 * rail.curvature * along_rail - vehicle.yaw_rate;
  return image;
}

}  // namespace lanefuse
