// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/thinned_line.hpp"

#include <algorithm>
#include <utility>

namespace lanefuse {
namespace {

double distance_to(const Pixel& point, const Pixel& from, const Pixel& to) {
  const Pixel along = to - from;
  const double length = along.squaredNorm();
  const double at = length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (from + at * along - point).norm();
}

}  // namespace

std::vector<Pixel> thinned_line(const std::vector<Pixel>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t corner = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to(points[i], points[first], points[last]);
      if (distance > farthest) {
        farthest = distance;
        corner = i;
      }
    }
    if (corner == first) continue;
    kept[corner] = true;
    open.emplace_back(first, corner);
    open.emplace_back(corner, last);
  }
  std::vector<Pixel> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) result.push_back(points[i]);
  }
  return result;
}

}  // namespace lanefuse
