// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "sensors/truth.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

/// A place on a road: by its station where the scene has a road, and in the world.
struct PlaceOnRoad {
  double station = 0;  ///< [m]
  Pose2 world_from_place;
};

/// The guard rail beside a place: its nearest point, heading along the road.
struct GuardRail {
  Pose2 world_from_rail;
  double curvature = 0;  ///< [1/m]
};

/// Where the guard rails stand, for radars that see things reflected in them.
class GuardRails {
 public:
  virtual ~GuardRails() = default;
  /// The rail on the left (+1) or right (-1) of the place, if there is one.
  [[nodiscard]] virtual std::optional<GuardRail> beside(const Scene& scene, const PlaceOnRoad& place,
                                                        int side) const = 0;
};

/// The rails of the scene's road.
class RoadRails final : public GuardRails {
 public:
  [[nodiscard]] std::optional<GuardRail> beside(const Scene& scene, const PlaceOnRoad& place,
                                                int side) const override;
};

/// Rails along the outermost boundaries of a recorded road, which says nothing of any.
class BoundaryRails final : public GuardRails {
 public:
  /// `beyond` [m]: from the outermost boundary to the rail.
  BoundaryRails(const TrueRoad& road, double beyond);
  [[nodiscard]] std::optional<GuardRail> beside(const Scene& scene, const PlaceOnRoad& place,
                                                int side) const override;

 private:
  struct Piece {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
  };
  std::vector<Piece> pieces_;  ///< of all boundaries
  double beyond_;
};

/// The vehicle as the rail beside it mirrors it: a vehicle on the rail's far side that moves along with it.
/// Its station and lateral place stay those of the vehicle.
SceneVehicle mirrored(const SceneVehicle& vehicle, const GuardRail& rail);

}  // namespace lanefuse
