// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/line_locator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {
namespace {

constexpr std::size_t kAround = 40;  ///< points to either side of the last place that are searched first

}  // namespace

LineLocator::LineLocator(const MapBoundary& boundary) {
  assert(boundary.points.size() >= 2);
  for (const Eigen::Vector3d& point : boundary.points) {
    const Eigen::Vector2d place = point.head<2>();
    along_.push_back(points_.empty() ? 0 : along_.back() + (place - points_.back()).norm());
    points_.push_back(place);
  }
}

std::size_t LineLocator::nearest(const Eigen::Vector2d& point, std::size_t begin, std::size_t end) const {
  const auto first = points_.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = points_.begin() + static_cast<std::ptrdiff_t>(end);
  const auto found = std::min_element(first, last, [&point](const auto& a, const auto& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  });
  return static_cast<std::size_t>(found - points_.begin());
}

/// The foot may lie a little beyond a segment's ends: on the outside of a bend no perpendicular leads there.
std::optional<LineLocator::Place> LineLocator::on_segment(const Eigen::Vector2d& point,
                                                          std::size_t segment) const {
  const Eigen::Vector2d way = points_[segment + 1] - points_[segment];
  const double length = way.norm();
  if (length <= 0) return std::nullopt;
  const Eigen::Vector2d ahead = way / length;
  const Eigen::Vector2d off = point - points_[segment];
  const double along = off.dot(ahead);
  const double slack = 0.05 * length;
  if (along < -slack || along > length + slack) return std::nullopt;
  return Place{along_[segment] + along, ahead.x() * off.y() - ahead.y() * off.x(),
               std::atan2(ahead.y(), ahead.x())};
}

std::optional<LineLocator::Place> LineLocator::locate(const Eigen::Vector2d& point, double reach) {
  std::size_t at = points_.size();
  if (last_) {
    const std::size_t begin = *last_ > kAround ? *last_ - kAround : 0;
    const std::size_t end = std::min(*last_ + kAround + 1, points_.size());
    at = nearest(point, begin, end);
    const bool at_rim = (at == begin && begin > 0) || (at + 1 == end && end < points_.size());
    if (at_rim) at = points_.size();
  }
  if (at == points_.size()) at = nearest(point, 0, points_.size());
  last_ = at;
  std::optional<Place> best;
  for (const std::size_t segment : {at, at - 1}) {  // at - 1 wraps to a segment that is not there
    if (segment + 1 >= points_.size() || segment > at) continue;
    const auto place = on_segment(point, segment);
    if (place && (!best || std::abs(place->lateral) < std::abs(best->lateral))) best = place;
  }
  return best && std::abs(best->lateral) <= reach ? best : std::nullopt;
}

}  // namespace lanefuse
