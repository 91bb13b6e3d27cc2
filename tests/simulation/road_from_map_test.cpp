// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_from_map.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "simulation/generated_road.hpp"
#include "simulation/road_as_map.hpp"

namespace lanefuse {
namespace {

Road drawn_road(std::uint64_t seed) {
  RoadEvent exit;
  exit.first = 300;
  return generated_road({RoadKind::curved, 1500, 100, {exit}}, nominal_preset().road, seed);
}

double distance(const Eigen::Vector2d& place, const MapBoundary& boundary) {
  double least = INFINITY;
  for (std::size_t i = 1; i < boundary.points.size(); ++i) {
    const Eigen::Vector2d from = boundary.points[i - 1].head<2>();
    const Eigen::Vector2d way = boundary.points[i].head<2>() - from;
    const double part = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (place - from - part * way).norm());
  }
  return least;
}

TEST(RoadFromMap, ItsLinesLieOnTheMapsBoundaries) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const RoadMap map = road_map(drawn_road(seed));
    const Road road = road_from_map(map, nominal_preset().road, 1, "map");
    ASSERT_EQ(road.line_count(), 7);
    for (int line = 0; line < road.line_count(); ++line) {
      const Stretch& stretch = road.parts().lines[static_cast<std::size_t>(line)].stretch;
      for (double station = stretch.begin + 5; station < stretch.end - 5; station += 7.3) {
        const Eigen::Vector2d place = road.pose(station, road.line_lateral(line, station)).position();
        double least = INFINITY;
        for (const MapBoundary& boundary : map.boundaries) least = std::min(least, distance(place, boundary));
        ASSERT_LT(least, 0.02) << "line " << line << " at " << station;
      }
    }
  }
}

TEST(RoadFromMap, HasTheMapsLanesWithTheirEndsAndPaint) {
  const Road drawn = drawn_road(2);
  const Road road = road_from_map(road_map(drawn), nominal_preset().road, 1, "map");
  ASSERT_EQ(road.lane_count(), drawn.lane_count());
  EXPECT_NEAR(road.length(), drawn.length(), 40) << "along the left line, which bends with the road";
  for (const double station : {200.0, 500.0, 900.0}) {
    const double there = station * road.length() / drawn.length();
    for (int lane = 0; lane < 3; ++lane) {
      EXPECT_NEAR(road.lane_width(lane, there), drawn.lane_width(lane, station), 0.04);
    }
  }
  EXPECT_EQ(road.marking(0, 500).type, MarkingType::solid);
  EXPECT_EQ(road.marking(1, 500).type, MarkingType::dashed);
  EXPECT_EQ(road.lane_kind(3), LaneKind::exit);
  EXPECT_NEAR(road.lane_end(3) - road.lane_begin(3), 250, 8);
}

TEST(RoadFromMap, IsSmoothToDriveOn) {
  const Road road = road_from_map(road_map(drawn_road(3)), nominal_preset().road, 1, "map");
  for (double station = 10; station < road.length() - 10; station += 2) {
    ASSERT_LT(std::abs(road.reference().curvature(station)), 1 / 400.0);
    for (int lane = 0; lane < 3; ++lane) ASSERT_LT(std::abs(road.lane_centre_slope(lane, station)), 0.02);
  }
}

/// One lane that goes 400 m, turns back to the left, and comes back as far.
RoadMap turning_back(double radius) {
  RoadMap map;
  for (const double left : {1.75, -1.75}) {
    MapBoundary boundary{map.boundaries.size() + 1, {}, {{}}};
    const double r = radius - left;
    for (double x = 0; x < 400; x += 2) boundary.points.emplace_back(x, left, 0);
    for (double a = 0; a < M_PI; a += 2 / r)
      boundary.points.emplace_back(400 + r * std::sin(a), radius - r * std::cos(a), 0);
    for (double x = 400; x >= 0; x -= 2) boundary.points.emplace_back(x, 2 * radius - left, 0);
    map.boundaries.push_back(boundary);
  }
  map.lanes = {{1, LaneKind::driving, 1, 2, {}, {}, {}}};
  return map;
}

TEST(RoadFromMap, MayTurnBack) {
  const Road road = road_from_map(turning_back(200), nominal_preset().road, 1, "bend");
  EXPECT_NEAR(road.length(), 800 + M_PI * 200, 30);
  EXPECT_GT(road.lane_end(0) - road.lane_begin(0), 1300);
}

TEST(RoadFromMap, RefusesMapsWithoutARoad) {
  EXPECT_THROW(road_from_map(RoadMap{}, nominal_preset().road, 1, "empty"), Error);
  RoadMap map;
  map.boundaries = {{1, {{0, 3.5, 0}, {90, 3.5, 0}}, {{}}}, {2, {{0, 0, 0}, {90, 0, 0}}, {{}}}};
  map.lanes = {{1, LaneKind::driving, 1, 2, {}, {}, {}}};
  EXPECT_THROW(road_from_map(map, nominal_preset().road, 1, "short"), Error);
}

}  // namespace
}  // namespace lanefuse
