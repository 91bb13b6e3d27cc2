// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// Finds places on one line of a map, for points that follow each other along it: the search begins where the
/// last one ended, and covers the whole line only for the first and after a jump.
class LineLocator {
 public:
  struct Place {
    double along = 0;    ///< [m] of arc length in the plane, from the line's beginning
    double lateral = 0;  ///< [m] of the point to the left of the line
    double heading = 0;  ///< [rad] of the line there
  };

  explicit LineLocator(const MapBoundary& boundary);

  /// The foot of the perpendicular from `point`, if it lies on the line and within `reach` [m].
  [[nodiscard]] std::optional<Place> locate(const Eigen::Vector2d& point, double reach);

  [[nodiscard]] double length() const { return along_.back(); }

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> along_;
  std::optional<std::size_t> last_;

  [[nodiscard]] std::size_t nearest(const Eigen::Vector2d& point, std::size_t begin, std::size_t end) const;
  [[nodiscard]] std::optional<Place> on_segment(const Eigen::Vector2d& point, std::size_t segment) const;
};

}  // namespace lanefuse
