// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/evaluation_json.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evaluation/exact_truth.hpp"
#include "evaluation/table_one.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::RoadScene;

EvaluationResult judged(const std::optional<SurveyedTruthConfig>& survey = {}) {
  const RoadScene scene;
  const TrueRoad road = testing::true_road(scene, -60, 95);
  ExactTruthEvaluation evaluation(road, survey);
  evaluation.add(testing::perfect_estimate(scene), testing::true_frame(scene));
  return evaluation.result();
}

TEST(EvaluationJson, HoldsEveryFigureOfARoad) {
  const nlohmann::ordered_json json = to_json(judged(SurveyedTruthConfig{}));
  for (const char* key :
       {"truth", "drive", "witness", "preset_hash", "cycles", "cycles_ok", "cycles_with_truth", "lanes",
        "wrong_lane_rate", "false_boundaries_per_frame", "false_lanes_per_frame", "resets", "nees",
        "consistency", "by_vehicles_ahead", "by_gap_ahead", "surveyed"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_FALSE(json.contains("baselines"));
  EXPECT_FALSE(json.contains("serial_camera"));
  EXPECT_EQ(json["lanes"]["ego"].size(), kDistanceCount);
  EXPECT_DOUBLE_EQ(json["surveyed"]["heading_deg"].get<double>(), 0.12);
}

TEST(EvaluationJson, WhatIsNotKnownIsNull) {
  const nlohmann::ordered_json json = to_json(judged());
  EXPECT_TRUE(json["lanes"]["ego"][12]["rmse_m"].is_null());             // the road ends before
  EXPECT_TRUE(json["by_gap_ahead"].back()["to"].is_null());              // without end
  EXPECT_TRUE(json["consistency"]["ego"][0]["protection_m"].is_null());  // vouched for none
  EXPECT_EQ(json["consistency"]["ego"][0]["n_protected"], 0);
  EXPECT_DOUBLE_EQ(json["consistency"]["ego"][0]["stated_sigma_m"].get<double>(), 0.1);
  EXPECT_EQ(json.dump().find("nan"), std::string::npos);
}

LaneStatistics times_the_papers(double ratio) {
  LaneStatistics lanes;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    for (const bool ego : {true, false}) {
      DeviationStatistics at;
      at.distance_m = distance_at(i);
      at.n = 10;
      const PaperRow& row = kTableOne[i / 2];
      at.rmse_m = ratio * (ego ? row.ego.rmse : row.adjacent.rmse);
      (ego ? lanes.ego : lanes.adjacent).push_back(at);
    }
  }
  return lanes;
}

std::size_t count(const LaneStatistics& lanes, AgainstPaper verdict) {
  std::size_t found = 0;
  for (const PaperComparison& one : compare_with_table_one(lanes)) found += one.verdict == verdict ? 1 : 0;
  return found;
}

TEST(TableOne, IsMetWithin35PercentNearAndAFactor2Far) {
  EXPECT_EQ(count(times_the_papers(1), AgainstPaper::alike), 14U);
  EXPECT_EQ(count(times_the_papers(1.34), AgainstPaper::alike), 14U);
  EXPECT_EQ(count(times_the_papers(1.36), AgainstPaper::worse), 10U);  // all but 100 and 120 m
  EXPECT_EQ(count(times_the_papers(2.01), AgainstPaper::worse), 14U);
  EXPECT_EQ(count(times_the_papers(0.66), AgainstPaper::alike), 14U);
  EXPECT_EQ(count(times_the_papers(0.64), AgainstPaper::better), 10U);
  EXPECT_EQ(count(times_the_papers(0.49), AgainstPaper::better), 14U);
}

TEST(TableOne, ItsFiguresBelongTogether) {
  for (const PaperRow& row : kTableOne) {
    for (const PaperFigures& figures : {row.ego, row.adjacent}) {
      EXPECT_NEAR(std::hypot(figures.mean, figures.sigma), figures.rmse, 0.011) << row.distance;
    }
  }
}

TEST(TableOne, SaysWhatWasNotJudged) {
  const auto all = compare_with_table_one(judged().lanes);
  ASSERT_EQ(all.size(), 14U);
  EXPECT_EQ(all.back().verdict, AgainstPaper::not_judged);
  EXPECT_TRUE(compare_with_table_one({}).empty());
}

}  // namespace
}  // namespace lanefuse
