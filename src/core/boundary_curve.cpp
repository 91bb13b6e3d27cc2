// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/boundary_curve.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

/// [m] to each side over which differences are taken: a whole number of points, so that what lies between
/// points errs alike at all of them and cancels.
constexpr double kReach = 4 * kPointSpacing;

/// What the points add to the clothoid; beyond their ends as much as there.
double departure_at(const Boundary& boundary, double x) {
  const std::vector<BoundaryPoint>& points = boundary.points;
  if (points.empty()) return 0;
  const auto departure = [&boundary](const BoundaryPoint& point) {
    return point.y - boundary.clothoid.y(point.x);
  };
  const auto next = std::partition_point(points.begin(), points.end(),
                                         [x](const BoundaryPoint& point) { return point.x < x; });
  if (next == points.begin()) return departure(points.front());
  if (next == points.end()) return departure(points.back());
  const auto last = next - 1;
  const double before = departure(*last);
  return before + (departure(*next) - before) * (x - last->x) / (next->x - last->x);
}

}  // namespace

double curve_at(const Boundary& boundary, double x) {
  return boundary.clothoid.y(x) + departure_at(boundary, x);
}

CurveShape shape_at(const Boundary& boundary, double x) {
  CurveShape shape{boundary.clothoid.slope(x), boundary.clothoid.curvature_at(x)};
  if (boundary.points.size() < 3) return shape;
  const double from = boundary.points.front().x;
  const double to = boundary.points.back().x;
  const double reach = std::min(kReach, std::floor((to - from) / 2 / kPointSpacing) * kPointSpacing);
  if (!(reach > 0)) return shape;
  // Near the ends the parabola through three places within is followed outwards.
  const double middle = std::clamp(x, from + reach, to - reach);
  const double before = departure_at(boundary, middle - reach);
  const double at = departure_at(boundary, middle);
  const double behind = departure_at(boundary, middle + reach);
  const double bend = (behind - 2 * at + before) / (reach * reach);
  shape.bend += bend;
  shape.slope += (behind - before) / (2 * reach) + bend * (std::clamp(x, from, to) - middle);
  return shape;
}

}  // namespace lanefuse
