// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/traffic_ahead.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "evaluation/exact_truth.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::kLaneWidth;
using testing::RoadScene;

/// A vehicle `ahead` [m] of the car, `lane` lanes to its left.
TrueObject vehicle(const RoadScene& scene, double ahead, int lane) {
  TrueObject object;
  const double y = scene.course.y(ahead) - kLaneWidth / 2 + lane * kLaneWidth;
  object.world_from_object = scene.world_from_vehicle * Pose2{ahead, y, scene.course.heading_at(ahead)};
  return object;
}

TrafficAhead traffic(const RoadScene& scene, const std::vector<TrueObject>& objects) {
  const TrueRoad road = testing::true_road(scene);
  TrueRoadView view(road);
  TrueFrame frame = testing::true_frame(scene);
  frame.objects = objects;
  return traffic_ahead(frame, TrueLanes(road).roles(view.look_from(scene.world_from_vehicle)));
}

TEST(TrafficAhead, CountsTheOwnLaneAndItsNeighbours) {
  RoadScene scene;
  scene.lanes_right = 2;
  const TrafficAhead ahead =
      traffic(scene, {vehicle(scene, 80, 0), vehicle(scene, 35, 0), vehicle(scene, 10, 1),
                      vehicle(scene, 120, -1), vehicle(scene, 60, -2), vehicle(scene, -12, 0)});
  EXPECT_EQ(ahead.vehicles, 4);  // neither the one two lanes away nor the one behind
  EXPECT_NEAR(*ahead.gap, 35, 1e-9);
}

TEST(TrafficAhead, SaysWhereNobodyIs) {
  const RoadScene scene;
  const TrafficAhead ahead = traffic(scene, {vehicle(scene, 152, 0), vehicle(scene, 40, 1)});
  EXPECT_EQ(ahead.vehicles, 1);
  EXPECT_FALSE(ahead.gap);
}

RC_GTEST_PROP(ConditionedDeviations, EachRangeHasTheStatisticsOfItsOwnCycles, ()) {
  const std::array<double, 3> limits{0, 10, 30};
  ConditionedDeviations conditioned(limits);
  const auto cycles = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 50), rc::gen::inRange(-3000, 3000)));
  std::array<std::vector<double>, 3> expected;
  for (const auto& [value, millimetres] : cycles) {
    const double deviation = millimetres * 1e-3;
    conditioned.add(value, {{kEgoLeft, 4, deviation, 0.1}, {kAdjacentRight, 4, std::nullopt, 0}});
    expected[value < 10 ? 0 : value < 30 ? 1 : 2].push_back(deviation);
  }
  const auto all = conditioned.statistics();
  RC_ASSERT(all.size() == 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const DeviationStatistics& ego = all[i].lanes.ego[4];
    RC_ASSERT(all[i].cycles == expected[i].size());
    RC_ASSERT(ego.n == expected[i].size());
    RC_ASSERT(all[i].lanes.adjacent[4].n == 0U);
    double squares = 0;
    for (const double deviation : expected[i]) squares += deviation * deviation;
    if (expected[i].empty()) continue;
    RC_ASSERT(std::abs(ego.rmse_m - std::sqrt(squares / static_cast<double>(expected[i].size()))) < 1e-9);
  }
}

TEST(ExactTruth, GathersDeviationsByTrafficAndGap) {
  const RoadScene scene;
  const TrueRoad road = testing::true_road(scene);
  ExactTruthEvaluation evaluation(road);
  TrueFrame frame = testing::true_frame(scene);
  evaluation.add(testing::perfect_estimate(scene), frame);
  frame.objects = {vehicle(scene, 50, 0), vehicle(scene, 90, 1)};
  evaluation.add(testing::perfect_estimate(scene), frame);
  const EvaluationResult result = evaluation.result();
  EXPECT_EQ(result.by_vehicles_ahead[0].cycles, 1U);
  EXPECT_EQ(result.by_vehicles_ahead[1].cycles, 1U);
  EXPECT_EQ(result.by_gap_ahead[2].cycles, 1U);  // 40 to 60 m
  EXPECT_EQ(result.by_gap_ahead.back().cycles, 1U);
  EXPECT_TRUE(std::isinf(result.by_gap_ahead.back().to));
  EXPECT_EQ(result.by_gap_ahead[2].lanes.ego[3].n, 2U);
}

}  // namespace
}  // namespace lanefuse
