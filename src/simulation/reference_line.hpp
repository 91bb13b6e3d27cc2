// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/pose2.hpp"

namespace lanefuse {

/// A piece of road whose curvature changes linearly: a straight, an arc or a clothoid transition.
struct RoadElement {
  double length = 0;          ///< [m], whole metres
  double curvature = 0;       ///< [1/m] at its beginning, positive to the left
  double curvature_rate = 0;  ///< [1/m^2]
};

/// A curve in the plane made of road elements, by arc length. Curvature and heading are exact; positions are
/// integrated so finely that their error is of the order of rounding. Memory: 16 bytes a metre.
class ReferenceLine {
 public:
  /// Starts at the origin, heading along x, if nothing else is said. `elements` are not empty.
  explicit ReferenceLine(const std::vector<RoadElement>& elements, const Pose2& start = {});

  [[nodiscard]] double length() const { return pieces_.back().begin + pieces_.back().element.length; }

  /// All of these continue beyond the ends with the curvature of the last element, for a few metres.
  [[nodiscard]] double curvature(double station) const;
  [[nodiscard]] double heading(double station) const;  ///< not wrapped, so that it is continuous
  [[nodiscard]] Pose2 pose(double station) const;

 private:
  struct Piece {
    double begin;
    double heading;  ///< at its beginning
    RoadElement element;
  };

  std::vector<Piece> pieces_;
  std::vector<Eigen::Vector2d> positions_;  ///< at every whole metre

  [[nodiscard]] const Piece& piece_at(double station) const;
  [[nodiscard]] Eigen::Vector2d displacement(double from, double to) const;
};

}  // namespace lanefuse
