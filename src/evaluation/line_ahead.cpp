// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/line_ahead.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace lanefuse {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// The segment, named by its first point, whose stretch of x holds `x`; the first or last one beyond the
/// ends.
std::size_t segment_at(const Points& points, double x) {
  const auto after =
      std::upper_bound(points.begin(), points.end(), x,
                       [](double value, const Eigen::Vector2d& point) { return value < point.x(); });
  const auto index = static_cast<std::size_t>(after - points.begin());
  return std::clamp<std::size_t>(index, 1, points.size() - 1) - 1;
}

/// Where the foot of `point` falls on segment `i`: 0 at its begin, 1 at its end, beyond where it falls
/// outside.
double foot_on(const Points& points, std::size_t i, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = points[i + 1] - points[i];
  return (point - points[i]).dot(along) / along.squaredNorm();
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

constexpr double kAtTheEnd = 1e-9;  // what rounding may put beyond an end

}  // namespace

void LineAhead::extend(const Eigen::Vector2d& point) {
  if (points_.empty() || point.x() >= points_.back().x() + kSmallestStep) points_.push_back(point);
}

std::optional<double> LineAhead::y(double x) const {
  if (points_.size() < 2) return std::nullopt;
  const std::size_t i = segment_at(points_, x);
  const double fraction = (x - points_[i].x()) / (points_[i + 1].x() - points_[i].x());
  if (fraction < -kAtTheEnd || fraction > 1 + kAtTheEnd) return std::nullopt;
  return points_[i].y() + fraction * (points_[i + 1].y() - points_[i].y());
}

double LineAhead::deviation(const Eigen::Vector2d& point) const {
  assert(points_.size() >= 2);
  std::size_t i = segment_at(points_, point.x());
  double foot = foot_on(points_, i, point);
  for (; foot < 0 && i > 0; foot = foot_on(points_, i, point)) --i;
  // Outside a bend the foot may fall between two segments: then their corner is nearest, and it ends this
  // one.
  for (; foot > 1 && i + 2 < points_.size() && foot_on(points_, i + 1, point) >= 0;
       foot = foot_on(points_, i, point)) {
    ++i;
  }
  if (i > 0) foot = std::max(foot, 0.0);
  if (i + 2 < points_.size()) foot = std::min(foot, 1.0);
  const Eigen::Vector2d along = points_[i + 1] - points_[i];
  const double distance = (point - points_[i] - foot * along).norm();
  return cross(along, point - points_[i]) < 0 ? -distance : distance;
}

}  // namespace lanefuse
