// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/judged_cycles.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "evaluation/evaluation_json.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

/// Ten cycles between true frames of a vehicle that drives 30 m ahead; with its track, or without any.
EvaluationResult judge(bool tracked) {
  const testing::RoadScene scene;
  const TrueRoad road = testing::true_road(scene);
  JudgedCycles cycles(road, {});
  for (int index = 0; index <= 11; ++index) {
    TrueFrame frame = testing::true_frame(scene);
    frame.time = Time{} + std::chrono::milliseconds(80 * index);
    TrueObject object;
    object.id = 1;
    object.world_from_object = scene.world_from_vehicle * Pose2{30.0 + index, 0, 0};
    frame.objects = {object};
    cycles.add({frame});
    if (index > 10) break;
    LaneEstimate estimate;
    estimate.time = frame.time + std::chrono::milliseconds(40);
    TrackedObject track;
    track.id = 7;
    track.x = 30.5 + index;  // where the vehicle is half way to the next frame
    const std::vector<TrackedObject> tracks(tracked ? 1 : 0, track);
    cycles.add(estimate, {}, tracks);
  }
  return cycles.finish();
}

TEST(JudgedCycles, JudgesTracksByTheTruthOfTheirOwnTime) {
  const EvaluationResult result = judge(true);
  ASSERT_TRUE(result.tracking);
  EXPECT_EQ(result.tracking->frames, 11U);
  EXPECT_EQ(result.tracking->all.mota(), 1);
  EXPECT_NEAR(result.tracking->gospa(), 0, 1e-6);
  EXPECT_EQ(to_json(result).at("tracking").at("idf1"), 1);
}

TEST(JudgedCycles, WithoutTracksSaysNothingOfThem) {
  const EvaluationResult result = judge(false);
  EXPECT_FALSE(result.tracking);
  EXPECT_FALSE(to_json(result).contains("tracking"));
}

}  // namespace
}  // namespace lanefuse
