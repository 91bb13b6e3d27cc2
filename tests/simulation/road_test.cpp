// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "simulation/road_as_map.hpp"
#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

Road nominal_road(std::uint64_t seed, RoadKind kind = RoadKind::gentle) {
  return {kind, 3000, nominal_preset().road, seed};
}

RC_GTEST_PROP(Road, TruePolylinesLieOnTheOffsetCurves, (std::uint64_t seed)) {
  const Road road = nominal_road(seed, RoadKind::curved);
  const TrueRoad truth = true_road(road);
  RC_ASSERT(truth.boundaries.size() == 4u);
  for (int i = 0; i < 4; ++i) {
    const auto& points = truth.boundaries[static_cast<std::size_t>(i)].points;
    for (std::size_t s = 0; s + 1 < points.size(); s += 17) {
      const auto station = static_cast<double>(s);
      const Eigen::Vector2d seen = road.reference().pose(station).inverse() * points[s];
      RC_ASSERT(std::abs(seen.x()) < 1e-9);
      RC_ASSERT(std::abs(seen.y() - road.line_lateral(i, station)) < 1e-9);
      const double step = 1 - road.reference().curvature(station + 0.5) * road.line_lateral(i, station);
      RC_ASSERT(std::abs((points[s + 1] - points[s]).norm() - step) < 1e-5);
    }
  }
}

RC_GTEST_PROP(Road, LanesLieBetweenTheirBoundaries, (std::uint64_t seed)) {
  const Road road = nominal_road(seed);
  const TrueRoad truth = true_road(road);
  RC_ASSERT(road.lane_width(0, 0) >= 3.5 && road.lane_width(0, 0) <= 3.75);
  for (int lane = 0; lane < 3; ++lane) {
    const TrueLane& entry = truth.lanes[static_cast<std::size_t>(lane)];
    RC_ASSERT(entry.left_boundary == truth.boundaries[static_cast<std::size_t>(lane)].id);
    RC_ASSERT(entry.right_boundary == truth.boundaries[static_cast<std::size_t>(lane) + 1].id);
    RC_ASSERT(entry.left_lane.has_value() == (lane > 0));
    RC_ASSERT(entry.right_lane.has_value() == (lane < 2));
    RC_ASSERT(road.lane_at(70, road.lane_centre(lane, 70)) == lane);
    RC_ASSERT(road.lane_at(70, road.line_lateral(lane, 70) - 0.01) == lane);
  }
}

TEST(Road, IsPaintedAsThePresetSays) {
  const Road road = nominal_road(1);
  for (const int edge : {0, 3}) {
    EXPECT_EQ(road.marking(edge, 0).type, MarkingType::solid);
    EXPECT_DOUBLE_EQ(road.marking_width(edge, 0), 0.30);
  }
  for (const int inner : {1, 2}) {
    EXPECT_EQ(road.marking(inner, 0).type, MarkingType::dashed);
    EXPECT_DOUBLE_EQ(road.marking_width(inner, 0), 0.15);
    int painted = 0, changes = 0;
    for (int decimetre = 0; decimetre < 18'000; ++decimetre) {
      painted += road.painted(inner, decimetre * 0.1);
      changes += road.painted(inner, decimetre * 0.1) != road.painted(inner, decimetre * 0.1 + 0.1);
    }
    EXPECT_NEAR(painted, 6000, 70);  // 6 m of every 18 m
    EXPECT_NEAR(changes, 200, 1);
  }
  EXPECT_NEAR(road.guard_rail(-1, 0), road.line_lateral(3, 0) - 3.0, 1e-12);
}

TEST(Road, CurvesMoreOnTheInside) {
  const Road road = nominal_road(5, RoadKind::curved);
  for (double station = 10; station < 2900; station += 50) {
    const double lateral = 5;
    const Pose2 step = road.pose(station - 0.5, lateral).inverse() * road.pose(station + 0.5, lateral);
    EXPECT_NEAR(step.heading / step.position().norm(), road.curvature(station, lateral), 1e-7);
  }
}

TEST(RoadHeight, BendsWithThePresetsSigma) {
  testing::Moments curvature;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Road road = nominal_road(seed);
    for (double s = 100; s < 2900; s += 250) curvature.add(2 * road.height().above_tangent(s, s + 2) / 4);
  }
  EXPECT_NEAR(curvature.sigma(), 1.667e-5, 0.15e-5);
}

TEST(RoadHeight, TouchesItsTangent) {
  const Road road = nominal_road(2);
  EXPECT_DOUBLE_EQ(road.height().above_tangent(500.3, 500.3), 0);
  EXPECT_NEAR(road.height().above_tangent(500.3, 500.4), 0, 1e-6);
}

}  // namespace
}  // namespace lanefuse
