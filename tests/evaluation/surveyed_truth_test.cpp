// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/surveyed_truth.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "evaluation/exact_truth.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::perfect_estimate;
using testing::RoadScene;
using testing::true_frame;
using testing::true_road;

/// A perfect estimate judged by surveyed truth in so many places that lie `step` apart [m]: what is left is
/// the truth's own error. The car stands on one scene; the survey only hears that it moves.
class Survey {
 public:
  Survey(const SurveyedTruthConfig& config, double step) {
    SurveyError error(config);
    RoadScene scene;
    scene.course = {testing::kLaneWidth / 2, 0, 0, 0};
    const TrueRoad road = true_road(scene);
    TrueRoadView view(road);
    const TrueRoles exact = TrueLanes(road).roles(view.look_from(scene.world_from_vehicle));
    const LaneEstimate estimate = perfect_estimate(scene);
    for (int i = 0; i < 4000; ++i) {
      error.advance(from_nanoseconds(static_cast<std::int64_t>(1e9 * step / 30 * i)), {step * i, 0});
      TrueRoles truth;
      for (const LaneRole role : {kEgoLeft, kEgoRight, kAdjacentLeft, kAdjacentRight}) {
        truth[role] = error.surveyed(exact[role], role);
      }
      for (const RoleDeviation& one : compare(estimated_roles(estimate, truth), truth)) deviations_.add(one);
    }
  }
  [[nodiscard]] LaneStatistics statistics() const { return deviations_.statistics(); }

 private:
  RoleDeviations deviations_;
};

TEST(SurveyedTruth, HasTheErrorsThatItSays) {
  const SurveyedTruthConfig config;
  const LaneStatistics lanes = Survey(config, 300).statistics();  // steps that are all but independent
  for (std::size_t i = 0; i < kDistanceCount; i += 4) {
    const double turned = config.heading * distance_at(i);
    EXPECT_NEAR(lanes.ego[i].rmse_m / std::hypot(config.ego, turned), 1, 0.06) << i;
    EXPECT_NEAR(lanes.adjacent[i].rmse_m / std::hypot(config.adjacent, turned), 1, 0.06) << i;
    EXPECT_NEAR(lanes.ego[i].mean_m, 0, 0.1 * lanes.ego[i].rmse_m) << i;
  }
}

TEST(SurveyedTruth, ItsSizeDoesNotDependOnHowFastItVaries) {
  const auto far_apart = Survey({}, 300).statistics();
  const auto close = Survey({}, 25).statistics();  // 100 km in small steps
  EXPECT_NEAR(close.ego[0].rmse_m / far_apart.ego[0].rmse_m, 1, 0.15);
  EXPECT_NEAR(close.adjacent[12].rmse_m / far_apart.adjacent[12].rmse_m, 1, 0.15);
}

TEST(SurveyedTruth, VariesSlowlyAlongTheWay) {
  SurveyError error({0.09, 0.19, 0, 1});
  RoleLine line;
  LineAhead piece;
  for (const double x : {-10.0, 100.0}) piece.extend({x, 0});
  line.add(piece);
  error.advance(Time{}, {0, 0});
  const double before = *error.surveyed(line, kEgoLeft).y(50);
  error.advance(Time{} + std::chrono::milliseconds(33), {1, 0});
  EXPECT_NEAR(*error.surveyed(line, kEgoLeft).y(50), before, 0.05);
  EXPECT_NE(*error.surveyed(line, kEgoLeft).y(50), before);
}

EvaluationResult judged(const std::optional<SurveyedTruthConfig>& survey) {
  const RoadScene scene;
  const TrueRoad road = true_road(scene);
  ExactTruthEvaluation evaluation(road, survey);
  for (int i = 0; i < 20; ++i) evaluation.add(perfect_estimate(scene), true_frame(scene));
  return evaluation.result();
}

TEST(SurveyedTruth, SameSeedSameFigures) {
  const EvaluationResult a = judged(SurveyedTruthConfig{});
  const EvaluationResult b = judged(SurveyedTruthConfig{});
  SurveyedTruthConfig other;
  other.seed = 2;
  const EvaluationResult c = judged(other);
  EXPECT_EQ(a.truth, "surveyed");
  EXPECT_EQ(a.surveyed, SurveyedTruthConfig{});
  EXPECT_EQ(a.lanes.ego[3].rmse_m, b.lanes.ego[3].rmse_m);
  EXPECT_NE(a.lanes.ego[3].rmse_m, c.lanes.ego[3].rmse_m);
  EXPECT_GT(a.lanes.ego[3].rmse_m, 0);
}

TEST(SurveyedTruth, WithoutErrorsIsTheExactTruth) {
  const auto exact = judged(std::nullopt).lanes.ego;
  const auto none = judged(SurveyedTruthConfig{0, 0, 0, 1}).lanes.ego;
  for (std::size_t i = 0; i < kDistanceCount; ++i) EXPECT_NEAR(exact[i].rmse_m, none[i].rmse_m, 1e-12);
}

TEST(SurveyedTruth, PutsNobodyIntoAnotherLane) {
  RoadScene scene;
  scene.course = {0.02, 0, 0, 0};  // the car is 2 cm right of its left boundary
  const TrueRoad road = true_road(scene);
  ExactTruthEvaluation evaluation(road, SurveyedTruthConfig{0.5, 0.5, 0, 3});
  for (int i = 0; i < 50; ++i) evaluation.add(perfect_estimate(scene), true_frame(scene));
  EXPECT_EQ(wrong_lane_rate(evaluation.result()), 0);
  EXPECT_EQ(false_lanes_per_cycle(evaluation.result()), 0);
  EXPECT_LT(evaluation.result().lanes.ego[0].p95_m, 2);
}

}  // namespace
}  // namespace lanefuse
