// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/moved_view.hpp"

#include <gtest/gtest.h>

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
