// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "roadmap/road_map.hpp"

namespace lanefuse::testing {

/// How far a point lies from a line; nothing where it lies before its beginning or after its end.
inline std::optional<double> distance_beside(const MapBoundary& line, const Eigen::Vector3d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  bool is_beyond = false;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Eigen::Vector3d along = line.points[i] - line.points[i - 1];
    const double share = (point - line.points[i - 1]).dot(along) / along.squaredNorm();
    const double distance = (line.points[i - 1] + std::clamp(share, 0.0, 1.0) * along - point).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    is_beyond = (i == 1 && share < 0) || (i + 1 == line.points.size() && share > 1);
  }
  return is_beyond ? std::nullopt : std::optional(nearest);
}

/// The largest distance of one line's points from another, where they run side by side; infinite if nowhere.
inline double deviation(const MapBoundary& points, const MapBoundary& line) {
  double largest = -1;
  for (const Eigen::Vector3d& point : points.points) {
    const std::optional<double> distance = distance_beside(line, point);
    if (distance) largest = std::max(largest, *distance);
    if (largest > 1) break;  // another boundary: how far exactly does not matter
  }
  return largest < 0 ? std::numeric_limits<double>::infinity() : largest;
}

inline double lane_deviation(const RoadMap& a, const MapLane& lane, const RoadMap& b, const MapLane& other) {
  double largest = 0;
  for (const auto boundary : {&MapLane::left_boundary, &MapLane::right_boundary}) {
    const MapBoundary& one = *find_boundary(a, lane.*boundary);
    const MapBoundary& two = *find_boundary(b, other.*boundary);
    largest = std::max({largest, deviation(one, two), deviation(two, one)});
  }
  return largest;
}

/// Which lane of the one map each lane of the other has become: the one between the same boundaries.
inline std::map<std::uint64_t, std::uint64_t> matched_lanes(const RoadMap& from, const RoadMap& to,
                                                            double tolerance) {
  std::map<std::uint64_t, std::uint64_t> matches;
  for (const MapLane& lane : from.lanes) {
    double least = std::numeric_limits<double>::infinity();
    for (const MapLane& other : to.lanes) {
      const double deviation = lane_deviation(from, lane, to, other);
      if (deviation < least) matches[lane.id] = other.id;
      least = std::min(least, deviation);
    }
    EXPECT_LE(least, tolerance) << "lane " << lane.id;
  }
  return matches;
}

/// Styles at places well away from changes of style.
inline void expect_same_styles(const MapBoundary& one, const MapBoundary& other) {
  for (std::size_t i = 0; i < one.styles.size(); ++i) {
    const double at = one.styles[i].from + 5;
    if (i + 1 < one.styles.size() && one.styles[i + 1].from < at + 5) continue;
    EXPECT_TRUE(style_at(other, at).marking == one.styles[i].marking) << one.id << " at " << at;
    EXPECT_EQ(style_at(other, at).width, one.styles[i].width) << one.id << " at " << at;
  }
}

/// Both maps have the same lanes between the same boundaries (to the tolerance [m]), with the same
/// neighbours, successors and kinds.
inline void expect_same_lanes(const RoadMap& from, const RoadMap& to, double tolerance) {
  ASSERT_EQ(from.lanes.size(), to.lanes.size());
  ASSERT_EQ(from.boundaries.size(), to.boundaries.size());
  const auto matches = matched_lanes(from, to, tolerance);
  const auto matched = [&matches](std::optional<std::uint64_t> lane) -> std::optional<std::uint64_t> {
    return lane ? std::optional(matches.at(*lane)) : std::nullopt;
  };
  for (const MapLane& lane : from.lanes) {
    const MapLane* other = find_lane(to, matches.at(lane.id));
    ASSERT_NE(other, nullptr);
    EXPECT_EQ(other->kind, lane.kind) << "lane " << lane.id;
    EXPECT_EQ(other->left_lane, matched(lane.left_lane)) << "lane " << lane.id;
    EXPECT_EQ(other->right_lane, matched(lane.right_lane)) << "lane " << lane.id;
    ASSERT_EQ(other->successors.size(), lane.successors.size()) << "lane " << lane.id;
    for (std::size_t i = 0; i < lane.successors.size(); ++i) {
      EXPECT_EQ(other->successors[i], matches.at(lane.successors[i]));
    }
  }
}

}  // namespace lanefuse::testing
