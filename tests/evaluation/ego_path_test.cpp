// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/ego_path.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::perfect_estimate;
using testing::RoadScene;

constexpr double kSpeed = 25;

Time at_ms(std::int64_t milliseconds) { return from_nanoseconds(milliseconds * 1000000); }

/// A drive of `seconds` with a constant yaw rate, a frame every 10 ms, somewhere in the world.
std::vector<TrueFrame> drive(double yaw_rate, double seconds, double speed = kSpeed) {
  std::vector<TrueFrame> frames;
  for (int i = 0; i <= static_cast<int>(seconds * 100); ++i) {
    TrueFrame frame;
    frame.time = at_ms(10 * i);
    frame.world_from_vehicle = Pose2{30, -20, 2.5} * constant_turn(speed, yaw_rate, 0.01 * i);
    frames.push_back(frame);
  }
  return frames;
}

LaneEstimate lane_along(double curvature, double offset, std::int64_t milliseconds) {
  RoadScene scene;
  scene.course = {testing::kLaneWidth / 2 + offset, 0, curvature, 0};
  LaneEstimate estimate = perfect_estimate(scene);
  estimate.time = at_ms(milliseconds);
  estimate.speed = kSpeed;
  estimate.yaw_rate = kSpeed * curvature;
  return estimate;
}

EvaluationResult evaluate(const std::vector<TrueFrame>& frames, const LaneEstimate& estimate,
                          bool vehicle_ahead = false) {
  EgoPathEvaluation evaluation(frames);
  evaluation.add(estimate, vehicle_ahead);
  return evaluation.result();
}

TEST(EgoPath, TheCentreOfTheRightLaneDeviatesNowhere) {
  const EvaluationResult result = evaluate(drive(0, 10), lane_along(0, 0, 1005));
  EXPECT_EQ(result.truth, "ego-path");
  ASSERT_EQ(result.lanes.ego.size(), kDistanceCount);
  for (const DeviationStatistics& at : result.lanes.ego) {
    EXPECT_EQ(at.n, 1U);
    EXPECT_NEAR(at.rmse_m, 0, 1e-9);
  }
  EXPECT_TRUE(result.lanes.adjacent.empty());
}

TEST(EgoPath, ALaneToTheLeftDeviatesToTheLeft) {
  EXPECT_NEAR(evaluate(drive(0, 10), lane_along(0, 0.3, 1000)).lanes.ego[6].mean_m, 0.3, 1e-9);
}

TEST(EgoPath, OnAnArcTheArcBaselineIsExactAndStraightIsNot) {
  const double curvature = 1 / 800.0;
  const EvaluationResult result = evaluate(drive(kSpeed * curvature, 10), lane_along(curvature, 0, 1000));
  ASSERT_TRUE(result.baselines);
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    const double x = distance_at(i);
    EXPECT_NEAR(result.baselines->arc[i].mean_m, 0, 1e-4);
    EXPECT_NEAR(result.baselines->straight[i].mean_m, 800 - std::hypot(800, x), 1e-4);
  }
}

TEST(EgoPath, BaselinesStandOnTheSameCyclesAndOnThoseWithAnEstimate) {
  const std::vector<TrueFrame> frames = drive(0, 20);
  EgoPathEvaluation evaluation(frames);
  evaluation.add(lane_along(0, 0, 1000), false);
  LaneEstimate nothing;
  nothing.time = at_ms(1080);
  evaluation.add(nothing, false);
  const EvaluationResult result = evaluation.result();
  EXPECT_EQ(result.cycles, 2U);
  EXPECT_EQ(result.cycles_ok, 1U);
  EXPECT_DOUBLE_EQ(result.lanes.ego[6].availability, 0.5);
  EXPECT_EQ(result.baselines->straight[6].n, 2U);
  EXPECT_DOUBLE_EQ(result.baselines->straight[6].availability, 1);
  EXPECT_EQ(result.baselines->straight_where_available[6].n, 1U);
  EXPECT_EQ(result.baselines->arc_where_available[6].n, 1U);
}

TEST(EgoPath, NeedsBothBoundariesOfTheLane) {
  LaneEstimate estimate = lane_along(0, 0, 1000);
  estimate.boundaries[2].range_end = 50;  // the right one of the ego lane
  const auto ego = evaluate(drive(0, 10), estimate).lanes.ego;
  EXPECT_DOUBLE_EQ(ego[5].availability, 1);
  EXPECT_DOUBLE_EQ(ego[6].availability, 0);
}

TEST(EgoPath, WhereTheCarNeverGetsThereIsNoTruth) {
  const auto ego = evaluate(drive(0, 4), lane_along(0, 0, 1000)).lanes.ego;  // 75 m to go
  EXPECT_EQ(ego[7].n, 1U);
  EXPECT_EQ(ego[8].n, 0U);
  EXPECT_TRUE(std::isnan(ego[8].availability));

  const EvaluationResult standing = evaluate(drive(0, 10, 0), lane_along(0, 0, 1000));
  EXPECT_TRUE(std::isnan(standing.lanes.ego[0].availability));
  const EvaluationResult late = evaluate(drive(0, 4), lane_along(0, 0, 5000));
  EXPECT_EQ(late.cycles, 1U);
  EXPECT_EQ(late.cycles_with_truth, 0U);
}

TEST(EgoPath, AGapInTheTruthEndsThePath) {
  std::vector<TrueFrame> frames = drive(0, 10);
  frames.erase(frames.begin() + 300, frames.begin() + 450);
  const auto path = driven_path(frames, at_ms(1000), 140);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->points().back().x(), 1.99 * kSpeed, 1e-6);
}

TEST(EgoPath, ThePathEndsWhereTheCarTurnsBack) {
  const std::vector<TrueFrame> frames = drive(0.5, 12);  // a circle of 50 m radius
  const auto path = driven_path(frames, at_ms(0), 140);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->points().back().x(), 50, 0.1);
  EXPECT_NEAR(path->points().back().y(), 50, 3);
}

TEST(EgoPath, CountsAvailabilityWithAVehicleAheadApart) {
  const std::vector<TrueFrame> frames = drive(0, 20);
  EgoPathEvaluation evaluation(frames);
  LaneEstimate near_sighted = lane_along(0, 0, 1080);
  for (Boundary& boundary : near_sighted.boundaries) boundary.range_end = 40;
  evaluation.add(lane_along(0, 0, 1000), true);
  evaluation.add(near_sighted, true);
  LaneEstimate nothing;
  nothing.time = at_ms(1160);
  evaluation.add(nothing, false);
  const auto ahead = evaluation.result().availability_with_vehicle_ahead;
  ASSERT_EQ(ahead.size(), kDistanceCount);
  EXPECT_EQ(ahead[6].cycles, 2U);
  EXPECT_DOUBLE_EQ(ahead[6].availability, 0.5);
  EXPECT_DOUBLE_EQ(ahead[4].availability, 1);
  EXPECT_TRUE(std::isnan(evaluate(frames, nothing).availability_with_vehicle_ahead[6].availability));
}

TEST(SmoothedYawRate, FollowsAStepWithinAboutASecond) {
  SmoothedYawRate rate;
  rate.add(at_ms(0), 0.2);
  EXPECT_DOUBLE_EQ(rate.value(), 0.2);
  for (int i = 1; i <= 25; ++i) rate.add(at_ms(40 * i), 0.0);
  EXPECT_NEAR(rate.value(), 0.2 * std::exp(-2), 1e-9);
}

}  // namespace
}  // namespace lanefuse
