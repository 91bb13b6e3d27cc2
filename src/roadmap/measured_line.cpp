// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/measured_line.hpp"

#include <algorithm>
#include <limits>

namespace lanefuse {

MeasuredLine::MeasuredLine(const std::vector<Eigen::Vector3d>& points)
    : points_(points), arcs_(points.size()) {
  for (std::size_t i = 1; i < points_.size(); ++i)
    arcs_[i] = arcs_[i - 1] + (points_[i] - points_[i - 1]).norm();
}

Eigen::Vector3d MeasuredLine::at(double arc) const {
  const auto after = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, arc);
  const std::size_t i = static_cast<std::size_t>(after - arcs_.begin());
  const double gap = arcs_[i] - arcs_[i - 1];
  const double share = gap > 0 ? std::clamp((arc - arcs_[i - 1]) / gap, 0.0, 1.0) : 0;
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

double MeasuredLine::nearest(const Eigen::Vector3d& point) const {
  double arc = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Eigen::Vector2d along = (points_[i] - points_[i - 1]).head<2>();
    const Eigen::Vector2d there = (point - points_[i - 1]).head<2>();
    const double share =
        along.squaredNorm() > 0 ? std::clamp(there.dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
    const double distance = (there - share * along).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    arc = arcs_[i - 1] + share * (arcs_[i] - arcs_[i - 1]);
  }
  return arc;
}

std::vector<Eigen::Vector3d> MeasuredLine::between(double from, double to) const {
  constexpr double kSamePoint = 0.001;  // [m]
  std::vector<Eigen::Vector3d> points = {at(from)};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (arcs_[i] > from + kSamePoint && arcs_[i] < to - kSamePoint) points.push_back(points_[i]);
  }
  points.push_back(at(to));
  return points;
}

}  // namespace lanefuse
