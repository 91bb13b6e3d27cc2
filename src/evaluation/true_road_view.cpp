// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/true_road_view.hpp"

#include <algorithm>

namespace lanefuse {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kJump =
    50;  // [m] from one look to the next: further, and the old place along the road says nothing

/// A boundary that is out of sight may come into it somewhere else than its nearest point so far: it is
/// searched whole after this much of way.
constexpr double kOutOfSight = 200;       // [m]
constexpr double kSearchAgainAfter = 50;  // [m]

double squared_distance(const Points& points, std::size_t i, const Eigen::Vector2d& position) {
  return (points[i] - position).squaredNorm();
}

std::size_t nearest_of_all(const Points& points, const Eigen::Vector2d& position) {
  const auto nearer = [&position](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - position).squaredNorm() < (b - position).squaredNorm();
  };
  return static_cast<std::size_t>(std::min_element(points.begin(), points.end(), nearer) - points.begin());
}

std::size_t nearest_from(const Points& points, std::size_t i, const Eigen::Vector2d& position) {
  const auto distance = [&](std::size_t at) { return squared_distance(points, at, position); };
  while (i + 1 < points.size() && distance(i + 1) <= distance(i)) ++i;
  while (i > 0 && distance(i - 1) < distance(i)) --i;
  return i;
}

}  // namespace

TrueRoadView::TrueRoadView(const TrueRoad& road)
    : road_(road),
      nearest_(road.boundaries.size(), 0),
      searched_at_(road.boundaries.size(), Eigen::Vector2d::Zero()),
      lines_(road.boundaries.size()) {}

const std::vector<LineAhead>& TrueRoadView::look_from(const Pose2& world_from_vehicle) {
  const Eigen::Vector2d position = world_from_vehicle.position();
  const bool jumped = !last_position_ || (position - *last_position_).norm() > kJump;
  const Pose2 vehicle_from_world = world_from_vehicle.inverse();
  for (std::size_t b = 0; b < lines_.size(); ++b) {
    const Points& points = road_.boundaries[b].points;
    lines_[b].clear();
    if (points.empty()) continue;
    if (jumped || is_search_due(b, position)) {
      nearest_[b] = nearest_of_all(points, position);
      searched_at_[b] = position;
    } else {
      nearest_[b] = nearest_from(points, nearest_[b], position);
    }
    cut(b, vehicle_from_world);
  }
  last_position_ = position;
  return lines_;
}

bool TrueRoadView::is_search_due(std::size_t boundary, const Eigen::Vector2d& position) const {
  const Points& points = road_.boundaries[boundary].points;
  return squared_distance(points, nearest_[boundary], position) > kOutOfSight * kOutOfSight &&
         (position - searched_at_[boundary]).norm() > kSearchAgainAfter;
}

void TrueRoadView::cut(std::size_t boundary, const Pose2& vehicle_from_world) {
  const Points& points = road_.boundaries[boundary].points;
  const auto x_of = [&](std::size_t i) { return (vehicle_from_world * points[i]).x(); };
  std::size_t first = nearest_[boundary];
  while (first > 0 && x_of(first) > -kViewBehind && x_of(first - 1) < x_of(first)) --first;
  double reached = -kViewBehind;
  for (std::size_t i = first; i < points.size() && reached < kViewAhead; ++i) {
    const Eigen::Vector2d point = vehicle_from_world * points[i];
    // Where the road turns back it is no longer ahead.
    if (i > first && point.x() < reached) break;
    lines_[boundary].extend(point);
    reached = point.x();
  }
}

}  // namespace lanefuse
