// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/evenly_spaced.hpp"

namespace lanefuse {

std::vector<Eigen::Vector2d> evenly_spaced(const std::vector<Eigen::Vector2d>& points, double spacing) {
  std::vector<Eigen::Vector2d> result{points.front()};
  double to_next = spacing;  // along the polyline
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    double at = to_next;
    for (; at <= length; at += spacing)
      result.push_back(points[i - 1] + (points[i] - points[i - 1]) * (at / length));
    to_next = at - length;
  }
  if (spacing - to_next > 1e-6) result.push_back(points.back());
  return result;
}

}  // namespace lanefuse
