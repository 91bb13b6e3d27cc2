// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_projection.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kSpacing = 1;        ///< [m] between points of a boundary
constexpr double kFarAside = 60;      ///< [m] what is further off is another road
constexpr double kTolerance = 0.015;  ///< [m] by which a course may miss its points
constexpr double kLongestKnot = 64;   ///< points between two knots

/// A boundary's points, closely spaced, with the arc length along it.
struct Sample {
  Eigen::Vector2d place;
  double along;
};

std::vector<Sample> samples_of(const MapBoundary& boundary) {
  std::vector<Sample> samples{{boundary.points.front().head<2>(), 0}};
  double along = 0;
  for (std::size_t i = 1; i < boundary.points.size(); ++i) {
    const Eigen::Vector3d step = boundary.points[i] - boundary.points[i - 1];
    const double pieces = std::max(1.0, std::ceil(step.norm() / kSpacing));
    for (double piece = 1; piece <= pieces; ++piece) {
      const Eigen::Vector3d place = boundary.points[i - 1] + step * (piece / pieces);
      samples.push_back({place.head<2>(), along + step.norm() * piece / pieces});
    }
    along += step.norm();
  }
  return samples;
}

double nearest_station(const ReferenceLine& reference, const Eigen::Vector2d& place) {
  double nearest = 0;
  for (double station = 0; station <= reference.length(); station += 5) {
    const auto distance = [&](double s) { return (reference.pose(s).position() - place).squaredNorm(); };
    if (distance(station) < distance(nearest)) nearest = station;
  }
  return nearest;
}

/// The foot of the perpendicular, from a station nearby.
ProjectedPoint foot(const ReferenceLine& reference, const Sample& sample, double station) {
  double lateral = 0;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector2d off = reference.pose(station).inverse() * sample.place;
    lateral = off.y();
    station += off.x() / std::max(0.2, 1 - reference.curvature(station) * lateral);
  }
  return {station, lateral, sample.along};
}

bool beside(const ReferenceLine& reference, const ProjectedPoint& point) {
  return point.station >= 0 && point.station <= reference.length() && std::abs(point.lateral) < kFarAside;
}

/// A boundary that goes along turns less than 45 degrees against the road.
bool goes_along(const ProjectedPoint& from, const ProjectedPoint& to) {
  const double way = to.station - from.station;
  return way > 0 && std::abs(to.lateral - from.lateral) < way;
}

LateralCourse::Knot knot_at(const std::vector<ProjectedPoint>& points, std::size_t i) {
  const ProjectedPoint& before = points[i == 0 ? 0 : i - 1];
  const ProjectedPoint& after = points[std::min(i + 1, points.size() - 1)];
  const double slope = (after.lateral - before.lateral) / (after.station - before.station);
  return {points[i].station, points[i].lateral, slope};
}

bool fits(const std::vector<ProjectedPoint>& points, std::size_t from, std::size_t to) {
  const LateralCourse course({knot_at(points, from), knot_at(points, to)});
  for (std::size_t i = from + 1; i < to; ++i) {
    if (std::abs(course.at(points[i].station) - points[i].lateral) > kTolerance) return false;
  }
  return true;
}

}  // namespace

std::vector<ProjectedPoint> project(const ReferenceLine& reference, const MapBoundary& boundary) {
  const std::vector<Sample> samples = samples_of(boundary);
  std::vector<ProjectedPoint> longest;
  std::vector<ProjectedPoint> run;
  double station = nearest_station(reference, samples.front().place);
  for (const Sample& sample : samples) {
    const ProjectedPoint point = foot(reference, sample, station);
    if (!run.empty() && !(beside(reference, point) && goes_along(run.back(), point))) {
      if (run.size() > longest.size()) longest = run;
      run.clear();
    }
    if (beside(reference, point)) run.push_back(point);
    station = std::clamp(point.station, 0.0, reference.length());
  }
  if (run.size() > longest.size()) longest = run;
  return longest.size() < 2 ? std::vector<ProjectedPoint>{} : longest;
}

LateralCourse course_through(const std::vector<ProjectedPoint>& points) {
  std::vector<LateralCourse::Knot> knots{knot_at(points, 0)};
  for (std::size_t from = 0; from + 1 < points.size();) {
    std::size_t step = std::min(static_cast<std::size_t>(kLongestKnot), points.size() - 1 - from);
    while (step > 1 && !fits(points, from, from + step)) step /= 2;
    from += step;
    knots.push_back(knot_at(points, from));
  }
  return LateralCourse(std::move(knots));
}

}  // namespace lanefuse
