// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/perception.hpp"

namespace lanefuse {
namespace {

using std::chrono::milliseconds;

Time at(int ms) { return Time{std::chrono::seconds(1000) + milliseconds(ms)}; }

VehicleMotion motion(int ms) { return {{at(ms), at(ms), 0}, 30.0, 0.0}; }

/// The times of the cycles that are due by `now`, in milliseconds.
std::vector<int> cycles_until(MultiLanePerception& perception, int now) {
  std::vector<int> times;
  while (const LaneEstimate* lanes = perception.advance(at(now))) {
    times.push_back(static_cast<int>((lanes->time - at(0)) / milliseconds(1)));
  }
  return times;
}

PerceptionConfig at_10_hz() {
  PerceptionConfig config;
  config.cycle_hz = 10;
  return config;
}

TEST(CycleClock, StandsStillBeforeTheFirstMeasurement) {
  MultiLanePerception perception(at_10_hz(), {});
  EXPECT_TRUE(cycles_until(perception, 100'000).empty());
}

TEST(CycleClock, TicksOnWholePeriodsAfterTheFirstMeasurement) {
  MultiLanePerception perception(at_10_hz(), {});
  perception.add(motion(130));
  EXPECT_THAT(cycles_until(perception, 199), ::testing::IsEmpty());
  EXPECT_THAT(cycles_until(perception, 200), ::testing::ElementsAre(200));
  EXPECT_THAT(cycles_until(perception, 200), ::testing::IsEmpty());
  EXPECT_THAT(cycles_until(perception, 599), ::testing::ElementsAre(300, 400, 500));
}

TEST(CycleClock, LooksOnlyAtWhatHadBeenReceivedInTime) {
  MultiLanePerception perception(at_10_hz(), {});
  perception.add(motion(100));
  perception.add(motion(150));
  const LaneEstimate* lanes = perception.advance(at(200));
  ASSERT_NE(lanes, nullptr);
  EXPECT_EQ(lanes->inputs, (InputAccounting{2, 0, 0}));
  perception.add(motion(200));
  lanes = perception.advance(at(300));
  ASSERT_NE(lanes, nullptr);
  EXPECT_EQ(lanes->inputs, (InputAccounting{1, 0, 0}));
}

TEST(CycleClock, GoesAtTheConfiguredPace) {
  for (const double hz : {1.0, 12.5, 40.0, 100.0}) {
    PerceptionConfig config;
    config.cycle_hz = hz;
    MultiLanePerception perception(config, {});
    perception.add(motion(1));
    EXPECT_EQ(cycles_until(perception, 8000).size(), static_cast<std::size_t>(8 * hz)) << hz;
  }
}

TEST(CycleClock, SaysWhatTheCarDid) {
  MultiLanePerception perception(at_10_hz(), {});
  for (int ms = 0; ms <= 100; ms += 10) perception.add(VehicleMotion{{at(ms), at(ms), 0}, 25.0, 0.1});
  const LaneEstimate* lanes = perception.advance(at(100));
  ASSERT_NE(lanes, nullptr);
  EXPECT_EQ(lanes->speed, 25);
  EXPECT_EQ(lanes->yaw_rate, 0.1);
  EXPECT_EQ(lanes->status, EstimateStatus::invalid);
  EXPECT_EQ(lanes->reason, StatusReason::warming_up);
}

TEST(CycleClock, CountsCallsOfItsStages) {
  MultiLanePerception perception(at_10_hz(), {});
  std::vector<Stage> stages;
  perception.on_stage([&](Stage stage) { stages.push_back(stage); });
  perception.add(motion(0));
  perception.advance(at(100));
  EXPECT_THAT(stages,
              ::testing::ElementsAre(Stage::sources, Stage::association, Stage::solve, Stage::lane_model));
}

}  // namespace
}  // namespace lanefuse
