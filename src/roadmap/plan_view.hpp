// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/pose2.hpp"

namespace lanefuse {

/// a + b p + c p^2 + d p^3.
struct Cubic {
  double a = 0;
  double b = 0;
  double c = 0;
  double d = 0;

  [[nodiscard]] double at(double p) const { return a + p * (b + p * (c + p * d)); }
  [[nodiscard]] double slope_at(double p) const { return b + p * (2 * c + p * 3 * d); }
};

/// A piece of a clothoid; a line or an arc where the rate, or both, are 0.
struct ClothoidPiece {
  double curvature = 0;       ///< [1/m] at its beginning
  double curvature_rate = 0;  ///< [1/m^2]
};

/// x and y [m] in the frame of the piece's beginning, by a parameter that grows with the station.
struct CubicPiece {
  Cubic u;
  Cubic v;
  double parameter_per_metre = 1;
};

/// y = v(x) in the frame of the piece's beginning (OpenDRIVE's old poly3).
struct GraphPiece {
  Cubic v;
};

/// One element of a road's reference line.
struct PlanElement {
  double station = 0;  ///< [m] along the road
  Pose2 begin;
  double length = 0;  ///< [m]
  std::variant<ClothoidPiece, CubicPiece, GraphPiece> shape;
};

/// A road's reference line in the plane.
class PlanView {
 public:
  /// In order of station, at least one, each longer than nothing.
  explicit PlanView(std::vector<PlanElement> elements);

  /// Before the first element and after the last, these go on.
  [[nodiscard]] Pose2 pose(double station) const;
  [[nodiscard]] double end() const;
  [[nodiscard]] const std::vector<PlanElement>& elements() const { return elements_; }

 private:
  std::vector<PlanElement> elements_;
};

}  // namespace lanefuse
