// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/longest_lane_chain.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace lanefuse {
namespace {

double length_of(const MapBoundary& boundary) {
  double length = 0;
  for (std::size_t i = 1; i < boundary.points.size(); ++i) {
    length += (boundary.points[i] - boundary.points[i - 1]).norm();
  }
  return length;
}

/// A lane runs as far as both of its boundaries do.
double length_of(const RoadMap& map, const MapLane& lane) {
  return std::min(length_of(*find_boundary(map, lane.left_boundary)),
                  length_of(*find_boundary(map, lane.right_boundary)));
}

/// Follows successors from a lane on, always to the longest one that was not yet passed: roads may run in
/// circles.
std::vector<const MapLane*> chain_from(const RoadMap& map, const MapLane& first) {
  std::vector<const MapLane*> chain;
  std::set<std::uint64_t> passed;
  for (const MapLane* lane = &first; lane;) {
    chain.push_back(lane);
    passed.insert(lane->id);
    const MapLane* longest = nullptr;
    for (const std::uint64_t id : lane->successors) {
      const MapLane* next = find_lane(map, id);
      if (next->kind != LaneKind::driving || passed.contains(id)) continue;
      if (!longest || length_of(map, *next) > length_of(map, *longest)) longest = next;
    }
    lane = longest;
  }
  return chain;
}

/// Whether the point lies ahead of the last two; boundaries of lanes in a row may overlap.
bool is_ahead(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& place) {
  if (points.empty()) return true;
  const Eigen::Vector2d way = place - points.back();
  if (points.size() < 2) return way.norm() > 0.01;
  return way.dot(points.back() - points[points.size() - 2]) > 0.01 * way.norm() && way.norm() > 0.01;
}

std::vector<Eigen::Vector2d> left_boundaries(const RoadMap& map, const std::vector<const MapLane*>& chain) {
  std::vector<Eigen::Vector2d> points;
  std::set<std::uint64_t> taken;
  for (const MapLane* lane : chain) {
    if (!taken.insert(lane->left_boundary).second) continue;
    for (const Eigen::Vector3d& point : find_boundary(map, lane->left_boundary)->points) {
      if (is_ahead(points, point.head<2>())) points.emplace_back(point.head<2>());
    }
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector2d> longest_lane_chain(const RoadMap& map) {
  std::vector<const MapLane*> longest;
  double longest_length = 0;
  for (const MapLane& lane : map.lanes) {
    if (lane.kind != LaneKind::driving) continue;
    const std::vector<const MapLane*> chain = chain_from(map, lane);
    double length = 0;
    for (const MapLane* part : chain) length += length_of(map, *part);
    if (length <= longest_length) continue;
    longest_length = length;
    longest = chain;
  }
  return left_boundaries(map, longest);
}

}  // namespace lanefuse
