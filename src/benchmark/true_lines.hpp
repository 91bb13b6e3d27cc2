// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "simulation/image_truth.hpp"

namespace lanefuse {

/// A line of the road as points in the vehicle frame, by their way along the road.
struct TrueLine {
  int line = 0;
  std::vector<Eigen::Vector2d> points;  ///< every two metres from the car on

  struct Place {
    double y = 0;      ///< [m]
    double slope = 0;  ///< dy / dx
  };
  /// Where the line is `x` [m] ahead; nothing beyond its ends.
  [[nodiscard]] std::optional<Place> at(double x) const;
};

/// The lines around the car, moved to the left by `offset(line, station)` [m].
template <class Offset>
std::vector<TrueLine> true_lines(const Scene& scene, const ImageTruth& truth, Offset offset) {
  constexpr double kSpacing = 2;
  constexpr double kReach = 150;
  std::vector<TrueLine> lines;
  const Pose2 vehicle_from_world = scene.ego.world_from_vehicle.inverse();
  for (const int line : truth.lines()) {
    TrueLine points{line, {}};
    for (double ahead = -kSpacing; ahead <= kReach; ahead += kSpacing) {
      const double station = scene.ego.station + ahead;
      if (!scene.road->line_exists(line, station)) continue;
      const Pose2 place =
          scene.road->pose(station, scene.road->line_lateral(line, station) + offset(line, station));
      points.points.emplace_back(vehicle_from_world * Eigen::Vector2d(place.x, place.y));
    }
    if (points.points.size() >= 2) lines.push_back(std::move(points));
  }
  return lines;
}

}  // namespace lanefuse
