// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/map_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "roadmap/geo_frame.hpp"
#include "roadmap/line_locator.hpp"

namespace lanefuse {
namespace {

constexpr double kReach = 1.5;         ///< [m]: further off it is another line
constexpr double kLongestStep = 10;    ///< [m] between compared points over which the line counts as covered
constexpr double kPartOfLongStep = 2;  ///< [m] at most, into which longer ones are divided

LineDeviation deviation_of(const std::vector<Eigen::Vector2d>& points) {
  LineDeviation deviation;
  deviation.count = points.size();
  if (points.empty()) return deviation;
  std::vector<double> magnitudes;
  double squares = 0;
  for (const Eigen::Vector2d& point : points) {
    deviation.mean += point.y() / static_cast<double>(points.size());
    squares += point.y() * point.y();
    magnitudes.push_back(std::abs(point.y()));
  }
  std::sort(magnitudes.begin(), magnitudes.end());
  deviation.rmse = std::sqrt(squares / static_cast<double>(points.size()));
  deviation.p95 = magnitudes[static_cast<std::size_t>(0.95 * static_cast<double>(magnitudes.size() - 1))];
  deviation.max = magnitudes.back();
  return deviation;
}

/// A line's points, and between those that lie far apart, as on a straight road, more of them.
std::vector<Eigen::Vector2d> compared_points(const MapBoundary& line) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3d& point : line.points) {
    const Eigen::Vector2d to = point.head<2>();
    if (!points.empty()) {
      const Eigen::Vector2d from = points.back();
      const double length = (to - from).norm();
      const double parts = length > kLongestStep ? std::ceil(length / kPartOfLongStep) : 1;
      for (double part = 1; part < parts; ++part) points.emplace_back(from + part / parts * (to - from));
    }
    points.push_back(to);
  }
  return points;
}

/// Where a line of the map lies beside a true boundary.
std::vector<Eigen::Vector2d> beside(const std::vector<Eigen::Vector2d>& line, LineLocator& boundary) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d& point : line) {
    const auto place = boundary.locate(point, kReach);
    if (place) points.emplace_back(place->along, place->lateral);
  }
  return points;
}

/// Along which most of the line's points lie, and of those the nearest.
bool fits_better(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b) {
  const auto near_ones = [](const std::vector<Eigen::Vector2d>& points) {
    return std::count_if(points.begin(), points.end(),
                         [](const Eigen::Vector2d& point) { return std::abs(point.y()) < kReach / 3; });
  };
  if (near_ones(a) != near_ones(b)) return near_ones(a) > near_ones(b);
  return a.size() > b.size();
}

double covered_length(const std::vector<Eigen::Vector2d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = points[i].x() - points[i - 1].x();
    if (step <= kLongestStep) length += step;
  }
  return length;
}

RoadMap moved_into(const RoadMap& truth, const std::optional<GeoOrigin>& origin) {
  if (!origin || !truth.origin || *origin == *truth.origin) return truth;
  const GeoFrame from(*truth.origin);
  const GeoFrame into(*origin);
  RoadMap moved = truth;
  for (MapBoundary& boundary : moved.boundaries) {
    for (Eigen::Vector3d& point : boundary.points) point = into.local(from.place(point));
  }
  return moved;
}

}  // namespace

RoadMap as_map(const TrueRoad& road, const std::optional<GeoOrigin>& origin) {
  RoadMap map{"exact road", origin, {}, {}};
  for (const TrueBoundary& boundary : road.boundaries) {
    MapBoundary line{boundary.id, {}, {{0, boundary.marking, boundary.marking_width}}};
    for (const Eigen::Vector2d& point : boundary.points) line.points.emplace_back(point.x(), point.y(), 0);
    map.boundaries.push_back(std::move(line));
  }
  for (const TrueLane& lane : road.lanes) {
    map.lanes.push_back({lane.id,
                         LaneKind::driving,
                         lane.left_boundary,
                         lane.right_boundary,
                         lane.left_lane,
                         lane.right_lane,
                         {}});
  }
  return map;
}

MapComparison compare(const RoadMap& map, const RoadMap& truth) {
  const RoadMap road = moved_into(truth, map.origin);
  MapComparison comparison;
  std::vector<LineLocator> locators;
  for (const MapBoundary& boundary : road.boundaries) {
    locators.emplace_back(boundary);
    comparison.boundaries.push_back({boundary.id, locators.back().length(), 0, {}, {}});
  }
  for (const MapBoundary& line : map.boundaries) {
    const std::vector<Eigen::Vector2d> points_of_line = compared_points(line);
    std::vector<Eigen::Vector2d> best;
    BoundaryComparison* owner = nullptr;
    for (std::size_t i = 0; i < locators.size(); ++i) {
      auto points = beside(points_of_line, locators[i]);
      if (points.empty() || (owner && !fits_better(points, best))) continue;
      best = std::move(points);
      owner = &comparison.boundaries[i];
    }
    comparison.strays += points_of_line.size() - best.size();
    if (owner) owner->points.insert(owner->points.end(), best.begin(), best.end());
  }
  std::vector<Eigen::Vector2d> all;
  double length = 0;
  double covered = 0;
  for (BoundaryComparison& boundary : comparison.boundaries) {
    std::sort(boundary.points.begin(), boundary.points.end(),
              [](const auto& a, const auto& b) { return a.x() < b.x(); });
    boundary.deviation = deviation_of(boundary.points);
    boundary.covered = covered_length(boundary.points);
    length += boundary.length;
    covered += boundary.covered;
    all.insert(all.end(), boundary.points.begin(), boundary.points.end());
  }
  comparison.all = deviation_of(all);
  comparison.covered_share = length > 0 ? covered / length : 0;
  return comparison;
}

}  // namespace lanefuse
