// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/false_lanes.hpp"

#include <gtest/gtest.h>

#include "evaluation/exact_truth.hpp"
#include "evaluation/reset_counter.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::kLaneWidth;
using testing::perfect_estimate;
using testing::RoadScene;
using testing::shift;

EvaluationResult judge(const RoadScene& scene, const LaneEstimate& estimate) {
  const TrueRoad road = testing::true_road(scene);
  ExactTruthEvaluation evaluation(road);
  evaluation.add(estimate, testing::true_frame(scene));
  return evaluation.result();
}

TEST(FalseLanes, AreNoneInAPerfectEstimate) {
  const RoadScene scene;
  EXPECT_EQ(judge(scene, perfect_estimate(scene)).false_lanes, 0U);
}

TEST(FalseLanes, ALaneBesideTheRoadIsOne) {
  const RoadScene scene;
  RoadScene wider = scene;
  wider.lanes_right = 2;  // on the emergency lane
  const EvaluationResult result = judge(scene, perfect_estimate(wider));
  EXPECT_EQ(result.false_lanes, 1U);
  EXPECT_EQ(result.false_boundaries, 1U);
}

TEST(FalseLanes, ALaneThatStraddlesABoundaryIsOne) {
  const RoadScene scene;
  LaneEstimate estimate = perfect_estimate(scene);
  shift(estimate, 0.9);
  EXPECT_EQ(judge(scene, estimate).false_lanes, 0U);  // off, but no other lanes
  shift(estimate, 0.5);
  // The middle of the left one is off the road, and the others hold a boundary inside.
  EXPECT_EQ(judge(scene, estimate).false_lanes, 3U);
}

TEST(FalseLanes, TwoLanesTakenForOneAreOne) {
  const RoadScene scene;
  LaneEstimate estimate = perfect_estimate(scene);
  estimate.lanes = {{1, 101, 102, {}, 2}, {2, 102, 104, 1, {}}};
  EXPECT_EQ(judge(scene, estimate).false_lanes, 1U);
}

TEST(FalseLanes, WhereTheTruthIsSilentNothingIsFalse) {
  const RoadScene scene;
  const TrueRoad road = testing::true_road(scene, -60, 10);
  ExactTruthEvaluation evaluation(road);
  RoadScene elsewhere = scene;
  elsewhere.course.lateral_offset += 2;
  evaluation.add(perfect_estimate(elsewhere), testing::true_frame(scene));
  EXPECT_EQ(evaluation.result().false_lanes, 0U);
  EXPECT_EQ(evaluation.result().false_boundaries, 0U);
}

LaneEstimate with_ego_lane(std::uint64_t left, EstimateStatus status = EstimateStatus::ok) {
  RoadScene scene;
  scene.lanes_left = scene.lanes_right = 0;
  LaneEstimate estimate = perfect_estimate(scene);
  estimate.boundaries[0].id = estimate.lanes[0].left_boundary = left;
  estimate.boundaries[1].id = estimate.lanes[0].right_boundary = left + 1;
  estimate.status = status;
  return estimate;
}

LaneEstimate without_lanes(EstimateStatus status) {
  LaneEstimate estimate;
  estimate.status = status;
  return estimate;
}

std::uint64_t resets(const std::vector<LaneEstimate>& estimates) {
  ResetCounter counter;
  for (const LaneEstimate& estimate : estimates) counter.add(estimate);
  return counter.count();
}

TEST(ResetCounter, StartingIsNone) {
  EXPECT_EQ(resets({without_lanes(EstimateStatus::invalid), with_ego_lane(1), with_ego_lane(1)}), 0U);
}

TEST(ResetCounter, FallingFromOkToInvalidIsOneEvenIfAllIsNewAfterwards) {
  EXPECT_EQ(resets({with_ego_lane(1), without_lanes(EstimateStatus::invalid), with_ego_lane(7)}), 1U);
}

TEST(ResetCounter, AnEgoLaneThatIsBornAnewIsOne) {
  EXPECT_EQ(resets({with_ego_lane(1), without_lanes(EstimateStatus::degraded), with_ego_lane(7)}), 1U);
  EXPECT_EQ(resets({with_ego_lane(1), with_ego_lane(7)}), 1U);
}

TEST(ResetCounter, ALaneChangeAndAGapAreNone) {
  EXPECT_EQ(resets({with_ego_lane(1), with_ego_lane(2), with_ego_lane(3)}), 0U);
  EXPECT_EQ(resets({with_ego_lane(1), without_lanes(EstimateStatus::degraded), with_ego_lane(1)}), 0U);
}

}  // namespace
}  // namespace lanefuse
