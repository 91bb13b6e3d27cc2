// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/moved_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/lane_description.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

TEST(MovedView, TheRoadStandsWhileTheCarMovesOn) {
  const testing::RoadScene scene;
  LaneEstimate estimate = testing::perfect_estimate(scene);
  estimate.yaw_rate = 0.05;
  for (const double seconds : {-0.2, 0.0, 0.3}) {
    const LaneEstimate moved = moved_by(estimate, seconds);
    const Pose2 old_from_new = constant_turn(estimate.speed, estimate.yaw_rate, seconds);
    EXPECT_EQ(moved.time, estimate.time + from_seconds(seconds));
    for (std::size_t i = 0; i < moved.boundaries.size(); ++i) {
      for (const double x : {5.0, 40.0, 80.0}) {
        const Eigen::Vector2d place = old_from_new * Eigen::Vector2d(x, moved.boundaries[i].clothoid.y(x));
        EXPECT_NEAR(estimate.boundaries[i].clothoid.y(place.x()), place.y(), 0.02) << seconds << " s, " << x;
      }
      EXPECT_NEAR(moved.boundaries[i].range_end, 130 - 30 * seconds, 0.01);
      EXPECT_NEAR(moved.boundaries[i].points.front().x, moved.boundaries[i].range_begin, 1e-9);
    }
  }
}

TEST(MovedView, PointsOffTheClothoidStandOnTheRoadToo) {
  constexpr double kRadius = 250;
  const auto on_circle = [](double x) { return kRadius - std::sqrt(kRadius * kRadius - x * x); };
  LaneEstimate estimate;
  estimate.speed = 30;
  estimate.yaw_rate = 30 / kRadius;
  Boundary& boundary = estimate.boundaries.emplace_back();
  boundary.clothoid.curvature = 1 / kRadius;
  boundary.range_end = 101;
  for (double x = 0; x <= 100; x += kPointSpacing)
    boundary.points.push_back({x, on_circle(x), 0.01 * x, 0.03 * x});
  // Whoever drives along a circle sees it as ever.
  const Boundary moved = moved_by(estimate, 0.3).boundaries.front();
  ASSERT_GT(moved.points.size(), 40U);
  EXPECT_NEAR(moved.points.back().x, 91, 2.5);
  EXPECT_GE(moved.range_end, moved.points.back().x);
  EXPECT_EQ(moved.points.front().x, moved.range_begin);
  for (std::size_t i = 0; i < moved.points.size(); ++i) {
    const BoundaryPoint& point = moved.points[i];
    EXPECT_NEAR(point.x, moved.range_begin + kPointSpacing * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(point.y, on_circle(point.x), 0.005) << point.x;
    EXPECT_NEAR(point.sigma, 0.01 * (point.x + 9), 0.02);
    EXPECT_NEAR(point.protection, 3 * point.sigma, 1e-9);
  }
}

TEST(MovedView, LanesMoveWithTheirBoundaries) {
  const testing::RoadScene scene;
  LaneEstimate estimate = testing::perfect_estimate(scene);
  describe_lanes(estimate);
  const LaneEstimate moved = moved_by(estimate, 0.3);
  ASSERT_FALSE(moved.lanes.empty());
  for (std::size_t i = 0; i < moved.lanes.size(); ++i) {
    EXPECT_NEAR(moved.lanes[i].range_end, estimate.lanes[i].range_end - 9, 0.1);
    EXPECT_NEAR(moved.lanes[i].centre.front().x, estimate.lanes[i].centre.front().x - 9, 0.1);
  }
}

TEST(MovedView, FeaturesStayOnTheRoadToo) {
  const Pose2 old_from_new{2.4, 0.1, 0.02};
  DebugView debug;
  debug.features.resize(1);
  debug.features[0].feature.x = 40;
  debug.features[0].feature.y = -3;
  debug.features[0].feature.heading = 0.1;
  debug.switches = {{7, Side::left, {10, 2}, {20, 2.5}, 1}};
  const DebugView moved = moved_by(debug, old_from_new);
  const Feature& feature = moved.features[0].feature;
  EXPECT_TRUE(
      (old_from_new * Eigen::Vector2d(feature.x, feature.y)).isApprox(Eigen::Vector2d(40, -3), 1e-12));
  EXPECT_NEAR(feature.heading, 0.08, 1e-12);
  EXPECT_TRUE((old_from_new * moved.switches[0].to).isApprox(Eigen::Vector2d(20, 2.5), 1e-12));
}

}  // namespace
}  // namespace lanefuse
