// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/serial_camera_model.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::Moments;
using testing::SceneRun;

/// Across a marking's centre line, of a clothoid's point: its inner edge moved outward by half the paint.
double error_at(const Scene& scene, const ClothoidMeasurement& seen, double x) {
  const double y = seen.clothoid.y(x);
  const Eigen::Vector2d place = testing::place_of(scene, {x, y});
  const int line = testing::nearest_line(*scene.road, place);
  const double outward = (seen.side == Side::left ? 0.5 : -0.5) * scene.road->marking_width(line, place.x());
  return place.y() + outward - scene.road->line_lateral(line, place.x());
}

TEST(SerialCameraModel, ErrsLikeTheStudysSerialCamera) {
  std::map<int, Moments> errors;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SceneRun run(seed);
    SerialCameraModel model(run.preset(), seed);
    run.watch(model, 80, [&](const Scene& scene, const Measurement& measurement) {
      const auto& lane = std::get<SerialLane>(measurement);
      if (!lane.left) return;
      for (const int x : {0, 20, 40, 60}) errors[x].add(error_at(scene, *lane.left, x));
    });
  }
  EXPECT_NEAR(errors[0].rms(), 0.04, 0.012);
  EXPECT_NEAR(errors[20].rms(), 0.06, 0.018);
  EXPECT_NEAR(errors[40].rms(), 0.11, 0.033);
  EXPECT_NEAR(errors[60].rms(), 0.21, 0.06);
}

TEST(SerialCameraModel, SeesAsFarAndAsOftenAsThePresetSays) {
  Moments range;
  double frames = 0, dropped = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SceneRun run(seed);
    SerialCameraModel model(run.preset(), seed);
    run.watch(model, 60, [&](const Scene&, const Measurement& measurement) {
      const auto& lane = std::get<SerialLane>(measurement);
      EXPECT_EQ(lane.left.has_value(), lane.right.has_value());
      frames += 1;
      dropped += !lane.left;
      if (!lane.left) return;
      range.add(lane.left->range_end);
      ASSERT_LE(lane.left->range_end, 90);
      ASSERT_TRUE(is_plausible(*lane.left));
      ASSERT_TRUE(is_plausible(*lane.right));
    });
  }
  EXPECT_NEAR(range.mean(), 62, 1);
  EXPECT_NEAR(dropped / frames, 0.02, 0.008);
}

TEST(SerialCameraModel, FollowsTheEgoCarIntoTheNextLane) {
  int changes = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SceneRun run(seed);
    SerialCameraModel model(run.preset(), seed);
    int lane_before = 1;
    run.watch(model, 150, [&](const Scene& scene, const Measurement& measurement) {
      const int lane = *scene.road->lane_at(scene.ego.station, scene.ego.lateral);
      changes += lane != lane_before;
      lane_before = lane;
      const auto& seen = std::get<SerialLane>(measurement);
      if (!seen.left) return;
      ASSERT_EQ(seen.left->marking, scene.road->marking(lane, scene.ego.station));
      ASSERT_EQ(seen.right->marking, scene.road->marking(lane + 1, scene.ego.station));
      ASSERT_NEAR(seen.left->clothoid.y(0) - seen.right->clothoid.y(0), scene.road->lane_width(lane, 0), 0.5);
      ASSERT_LT(std::abs(error_at(scene, *seen.left, 10)), 0.5);
    });
  }
  EXPECT_GE(changes, 3);
}

TEST(SerialLaneTracker, FindsAStillLane) {
  SerialLaneTracker tracker(0.001);
  const Clothoid middle{0.3, 0.01, 4e-4, 1e-6};
  std::vector<SerialLaneTracker::Point> points;
  for (double x = 5; x < 60; x += 3) {
    points.push_back({{x, middle.y(x) + 1.8}, Side::left});
    points.push_back({{x, middle.y(x) - 1.8}, Side::right});
  }
  EXPECT_FALSE(tracker.settled());
  for (int i = 0; i < 50; ++i) tracker.update(points);
  EXPECT_TRUE(tracker.settled());
  const Clothoid left = tracker.boundary(Side::left).clothoid;
  EXPECT_NEAR(left.lateral_offset, 2.1, 1e-3);
  EXPECT_NEAR(left.y(60), middle.y(60) + 1.8, 2e-3);
  EXPECT_EQ(tracker.boundary(Side::right).side, Side::right);
}

TEST(SerialLaneTracker, MovesTheLaneWithTheCar) {
  SerialLaneTracker tracker(0.001);
  const Clothoid lane{1.0, 0.02, 1e-3, 0};
  for (int i = 0; i < 60; ++i) {
    std::vector<SerialLaneTracker::Point> points;
    for (double x = 5; x < 50; x += 3) points.push_back({{x, lane.y(x) + 1.7}, Side::left});
    for (double x = 5; x < 50; x += 3) points.push_back({{x, lane.y(x) - 1.7}, Side::right});
    tracker.update(points);
  }
  tracker.predict(0.5, 20, 0.01);
  const Pose2 old_from_new = constant_turn(20, 0.01, 0.5);
  const Clothoid expected = transform(lane, old_from_new);
  EXPECT_NEAR(tracker.boundary(Side::left).clothoid.lateral_offset, expected.lateral_offset + 1.7, 0.01);
  EXPECT_NEAR(tracker.boundary(Side::left).clothoid.heading, expected.heading, 1e-3);
}

}  // namespace
}  // namespace lanefuse
