// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// A line whose length has been measured, for finding places along it.
class MeasuredLine {
 public:
  explicit MeasuredLine(const std::vector<Eigen::Vector3d>& points);

  [[nodiscard]] double length() const { return arcs_.back(); }
  [[nodiscard]] Eigen::Vector3d at(double arc) const;
  /// The arc length at which the line is nearest to the point (in the plane).
  [[nodiscard]] double nearest(const Eigen::Vector3d& point) const;
  /// The points from one place to another, both included.
  [[nodiscard]] std::vector<Eigen::Vector3d> between(double from, double to) const;

 private:
  std::vector<Eigen::Vector3d> points_;
  std::vector<double> arcs_;
};

}  // namespace lanefuse
