// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/exact_truth.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::kLaneWidth;
using testing::perfect_estimate;
using testing::reshape;
using testing::RoadScene;
using testing::shift;
using testing::true_frame;
using testing::true_road;

EvaluationResult evaluate(const TrueRoad& road, const RoadScene& scene, const LaneEstimate& estimate) {
  ExactTruthEvaluation evaluation(road);
  evaluation.add(estimate, true_frame(scene));
  return evaluation.result();
}

EvaluationResult evaluate(const RoadScene& scene, const LaneEstimate& estimate) {
  return evaluate(true_road(scene), scene, estimate);
}

TEST(ExactTruth, ThePerfectEstimateDeviatesNowhere) {
  const RoadScene scene;
  const EvaluationResult result = evaluate(scene, perfect_estimate(scene));
  EXPECT_EQ(result.truth, "exact");
  for (const auto* lanes : {&result.lanes.ego, &result.lanes.adjacent}) {
    ASSERT_EQ(lanes->size(), kDistanceCount);
    for (const DeviationStatistics& at : *lanes) {
      EXPECT_EQ(at.n, 2U);
      EXPECT_NEAR(at.rmse_m, 0, 1e-9);
      EXPECT_NEAR(at.p95_m, 0, 1e-9);
      EXPECT_DOUBLE_EQ(at.availability, 1);
    }
  }
  EXPECT_EQ(result.cycles, 1U);
  EXPECT_EQ(result.cycles_ok, 1U);
  EXPECT_EQ(result.cycles_with_truth, 1U);
  EXPECT_EQ(wrong_lane_rate(result), 0);
  EXPECT_EQ(false_boundaries_per_cycle(result), 0);
}

TEST(ExactTruth, AConstantOffsetIsTheMeanOnAStraightRoad) {
  RoadScene scene;
  scene.course = {kLaneWidth / 2, 0, 0, 0};
  LaneEstimate estimate = perfect_estimate(scene);
  shift(estimate, 0.2);
  for (const DeviationStatistics& at : evaluate(scene, estimate).lanes.ego) {
    EXPECT_NEAR(at.mean_m, 0.2, 1e-9);
    EXPECT_NEAR(at.sigma_m, 0, 1e-9);
    EXPECT_NEAR(at.rmse_m, 0.2, 1e-9);
  }
}

TEST(ExactTruth, OnTheLineTheLanesOfBothSidesMayAnswer) {
  RoadScene scene;
  scene.course = {kLaneWidth - 0.05, 0, 0, 0};  // the car has just crossed into this lane
  LaneEstimate estimate = perfect_estimate(scene);
  shift(estimate, 0.2);  // and is still in the old one, if one asks the estimate
  const EvaluationResult near = evaluate(scene, estimate);
  EXPECT_NEAR(near.lanes.ego[0].rmse_m, 0.2, 1e-9);
  EXPECT_EQ(near.cycles_in_wrong_lane, 0U);
  shift(estimate, 0.3);
  const EvaluationResult far = evaluate(scene, estimate);
  EXPECT_GT(far.lanes.ego[0].rmse_m, kLaneWidth - 0.6);
}

TEST(ExactTruth, MeasuresAcrossAnObliqueRoad) {
  RoadScene scene;
  scene.course = {kLaneWidth / 2, 0.2, 0, 0};
  LaneEstimate estimate = perfect_estimate(scene);
  shift(estimate, -0.3);
  EXPECT_NEAR(evaluate(scene, estimate).lanes.ego[6].mean_m, -0.3 * std::cos(std::atan(0.2)), 1e-9);
}

TEST(ExactTruth, DoesNotCareWhereInTheWorldTheRoadLies) {
  RoadScene here;
  RoadScene turned = here;
  turned.world_from_vehicle = {-4000, 900, 3.1};
  LaneEstimate estimate = perfect_estimate(here);
  shift(estimate, 0.25);
  reshape(estimate.boundaries[1], [](Clothoid& clothoid) { clothoid.heading += 0.01; });
  const auto a = evaluate(here, estimate).lanes.ego;
  const auto b = evaluate(turned, estimate).lanes.ego;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    EXPECT_NEAR(a[i].mean_m, b[i].mean_m, 1e-9);
    EXPECT_NEAR(a[i].sigma_m, b[i].sigma_m, 1e-9);
  }
}

TEST(ExactTruth, ABoundaryAnswersOnlyWithinItsRange) {
  const RoadScene scene;
  LaneEstimate estimate = perfect_estimate(scene, 70);
  estimate.boundaries[1].range_begin = 10;
  const auto ego = evaluate(scene, estimate).lanes.ego;
  EXPECT_DOUBLE_EQ(ego[0].availability, 0.5);
  EXPECT_DOUBLE_EQ(ego[1].availability, 1);
  EXPECT_DOUBLE_EQ(ego[7].availability, 1);
  EXPECT_DOUBLE_EQ(ego[8].availability, 0);
  EXPECT_TRUE(std::isnan(ego[8].rmse_m));
}

TEST(ExactTruth, WhereTheTrueRoadEndsNothingIsAsked) {
  const RoadScene scene;
  const auto ego = evaluate(true_road(scene, -60, 85), scene, perfect_estimate(scene)).lanes.ego;
  EXPECT_EQ(ego[8].n, 2U);
  EXPECT_EQ(ego[9].n, 0U);
  EXPECT_TRUE(std::isnan(ego[9].availability));
}

TEST(ExactTruth, AsksOnlyForNeighboursThatExist) {
  RoadScene leftmost;
  leftmost.lanes_left = 0;
  const EvaluationResult result = evaluate(leftmost, perfect_estimate(leftmost));
  EXPECT_EQ(result.lanes.ego[3].n, 2U);
  EXPECT_EQ(result.lanes.adjacent[3].n, 1U);
  EXPECT_DOUBLE_EQ(result.lanes.adjacent[3].availability, 1);

  RoadScene alone = leftmost;
  alone.lanes_right = 0;
  EXPECT_TRUE(std::isnan(evaluate(alone, perfect_estimate(alone)).lanes.adjacent[3].availability));
}

TEST(ExactTruth, ANeighbourThatTheEstimateLacksIsUnavailable) {
  const RoadScene scene;
  LaneEstimate estimate = perfect_estimate(scene);
  estimate.lanes[1].left_lane.reset();
  const auto adjacent = evaluate(scene, estimate).lanes.adjacent;
  EXPECT_DOUBLE_EQ(adjacent[4].availability, 0.5);
  EXPECT_EQ(adjacent[4].n, 1U);
}

TEST(ExactTruth, WithoutAnEgoLaneAllIsUnavailable) {
  const RoadScene scene;
  const EvaluationResult result = evaluate(scene, LaneEstimate{});
  EXPECT_DOUBLE_EQ(result.lanes.ego[0].availability, 0);
  EXPECT_DOUBLE_EQ(result.lanes.adjacent[0].availability, 0);
  EXPECT_EQ(result.cycles_ok, 0U);
  EXPECT_TRUE(std::isnan(wrong_lane_rate(result)));
}

TEST(ExactTruth, RolesMoveWithTheCarThroughALaneChange) {
  RoadScene before;
  before.course = {0.1, 0, 0, 0};
  const TrueRoad road = true_road(before);
  RoadScene after = before;  // the car has crossed its left boundary
  after.world_from_vehicle = before.world_from_vehicle * Pose2{10, 0.2, 0};
  LaneEstimate estimate = perfect_estimate(before);
  shift(estimate, -0.2);
  const EvaluationResult result = evaluate(road, after, estimate);
  EXPECT_NEAR(result.lanes.ego[2].rmse_m, 0, 1e-9);
  EXPECT_EQ(result.lanes.ego[2].n, 2U);
  EXPECT_EQ(result.lanes.adjacent[2].n, 1U);  // in the leftmost lane now
  EXPECT_NEAR(result.lanes.adjacent[2].rmse_m, 0, 1e-9);
}

TEST(ExactTruth, TheWrongLaneIsALaneWidthOffAndCounted) {
  RoadScene scene;
  scene.course = {0.1, 0, 0, 0};
  LaneEstimate estimate = perfect_estimate(scene);
  shift(estimate, -0.5);  // believes to have crossed the left boundary, and to be well beyond it
  const EvaluationResult result = evaluate(scene, estimate);
  EXPECT_NEAR(result.lanes.ego[0].mean_m, kLaneWidth - 0.5, 1e-9);
  EXPECT_EQ(wrong_lane_rate(result), 1);
}

TEST(ExactTruth, CountsBoundariesThatAreNotThere) {
  const RoadScene scene;
  LaneEstimate estimate = perfect_estimate(scene);
  reshape(estimate.boundaries[0], [](Clothoid& clothoid) { clothoid.lateral_offset += 1.2; });
  reshape(estimate.boundaries[3], [](Clothoid& clothoid) { clothoid.lateral_offset += 0.8; });
  EXPECT_EQ(evaluate(scene, estimate).false_boundaries, 1U);
}

TEST(ExactTruth, ConsistencyIsOneWhereSigmaIsTheDeviation) {
  RoadScene scene;
  scene.course = {kLaneWidth / 2, 0, 0, 0};
  LaneEstimate estimate = perfect_estimate(scene);  // states a sigma of 0.1 m
  shift(estimate, 0.1);
  EXPECT_NEAR(evaluate(scene, estimate).consistency.ego[5].mean_normalised_square, 1, 1e-9);
  shift(estimate, 0.1);
  EXPECT_NEAR(evaluate(scene, estimate).consistency.adjacent[5].mean_normalised_square, 4, 1e-9);
  for (Boundary& boundary : estimate.boundaries) {
    boundary.covariance.setZero();
    sample_points(boundary);
  }
  EXPECT_EQ(evaluate(scene, estimate).consistency.ego[5].n, 0U);
}

TEST(ExactTruth, CoverageCountsWhatLiesInsideTheStatedIntervals) {
  RoadScene scene;
  scene.course = {kLaneWidth / 2, 0, 0, 0};
  const TrueRoad road = true_road(scene);
  ExactTruthEvaluation evaluation(road);
  for (const double sigmas : {0.9, 1.5, 2.2, 3.0}) {
    LaneEstimate estimate = perfect_estimate(scene);
    shift(estimate, 0.1 * sigmas);
    evaluation.add(estimate, true_frame(scene));
  }
  const ConsistencyStatistics at = evaluation.result().consistency.ego[0];
  EXPECT_DOUBLE_EQ(at.within_68, 0.25);
  EXPECT_DOUBLE_EQ(at.within_95, 0.5);
  EXPECT_DOUBLE_EQ(at.within_99, 0.75);
}

TEST(ExactTruth, ProtectionLevelsAreHeldAgainstTheirBoundarysOwnDeviation) {
  RoadScene scene;
  scene.course = {kLaneWidth / 2, 0, 0, 0};
  LaneEstimate estimate = perfect_estimate(scene);
  shift(estimate, 0.3);
  for (Boundary& boundary : estimate.boundaries) {
    for (BoundaryPoint& point : boundary.points) point.protection = point.x < 50 ? 0.2 : 0.4;
  }
  for (BoundaryPoint& point : estimate.boundaries[1].points) point.protection *= 2;
  for (BoundaryPoint& point : estimate.boundaries[3].points) point.protection = 0;
  const LaneConsistency consistency = evaluate(scene, estimate).consistency;
  EXPECT_DOUBLE_EQ(consistency.ego[1].misleading_rate, 0.5) << "only the right boundary says 0.2";
  EXPECT_DOUBLE_EQ(consistency.ego[1].protection_m, 0.3);
  EXPECT_DOUBLE_EQ(consistency.ego[8].misleading_rate, 0);
  EXPECT_EQ(consistency.adjacent[1].n_protected, 1U) << "the rightmost vouches for nothing";
  EXPECT_DOUBLE_EQ(consistency.adjacent[1].misleading_rate, 1);
}

TEST(ExactTruth, KeepsWhereTheErrorWasHowLarge) {
  RoadScene scene;
  scene.course = {kLaneWidth / 2, 0, 0, 0};
  const TrueRoad road = true_road(scene);
  ExactTruthEvaluation evaluation(road);
  LaneEstimate estimate = perfect_estimate(scene);
  reshape(estimate.boundaries[1], [](Clothoid& clothoid) { clothoid.lateral_offset -= 0.3; });
  evaluation.add(estimate, true_frame(scene));
  evaluation.add(LaneEstimate{}, true_frame(scene));
  ASSERT_EQ(evaluation.trace().size(), 2U);
  EXPECT_EQ(evaluation.trace()[0].position, scene.world_from_vehicle.position());
  EXPECT_NEAR(evaluation.trace()[0].error, 0.3, 1e-9);
  EXPECT_TRUE(std::isnan(evaluation.trace()[1].error));
}

TEST(ExactTruth, OffTheRoadACycleIsCountedAndNotJudged) {
  RoadScene scene;
  const TrueRoad road = true_road(scene);
  RoadScene meadow = scene;
  meadow.world_from_vehicle = scene.world_from_vehicle * Pose2{0, 40, 0};
  const EvaluationResult result = evaluate(road, meadow, perfect_estimate(scene));
  EXPECT_EQ(result.cycles, 1U);
  EXPECT_EQ(result.cycles_with_truth, 0U);
  EXPECT_EQ(result.lanes.ego[0].n, 0U);

  ExactTruthEvaluation evaluation(road);
  evaluation.add_without_truth(perfect_estimate(scene));
  EXPECT_EQ(evaluation.result().cycles, 1U);
}

}  // namespace
}  // namespace lanefuse
