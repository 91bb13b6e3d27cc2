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
  EXPECT_THAT(cycles_until(perception, 200), ::testing::IsEmpty());
  EXPECT_THAT(cycles_until(perception, 201), ::testing::ElementsAre(200));
  EXPECT_THAT(cycles_until(perception, 201), ::testing::IsEmpty());
  EXPECT_THAT(cycles_until(perception, 600), ::testing::ElementsAre(300, 400, 500));
}

TEST(CycleClock, LooksOnlyAtWhatHadBeenReceivedInTime) {
  MultiLanePerception perception(at_10_hz(), {});
  perception.add(motion(100));
  perception.add(motion(150));
  const LaneEstimate* lanes = perception.advance(at(201));
  ASSERT_NE(lanes, nullptr);
  EXPECT_EQ(lanes->inputs, (InputAccounting{2, 0, 0}));
  perception.add(motion(200));
  lanes = perception.advance(at(301));
  ASSERT_NE(lanes, nullptr);
  EXPECT_EQ(lanes->inputs, (InputAccounting{1, 0, 0}));
}

TEST(CycleClock, GoesAtTheConfiguredPace) {
  for (const double hz : {1.0, 12.5, 40.0, 100.0}) {
    PerceptionConfig config;
    config.cycle_hz = hz;
    MultiLanePerception perception(config, {});
    perception.add(motion(1));
    EXPECT_EQ(cycles_until(perception, 8001).size(), static_cast<std::size_t>(8 * hz)) << hz;
  }
}

ObjectList vehicles(int measured, int received) {
  return {{at(measured), at(received), 3}, {TrackedObject{1, 40, 0, 0, 30}}};
}

/// What became of a list that was measured at 0 and received now, and once more before if it comes twice.
InputAccounting fate_of_late_list(double reorder_window_s, int received, bool twice) {
  PerceptionConfig config = at_10_hz();
  config.reorder_window_s = reorder_window_s;
  MultiLanePerception perception(config, {});
  InputAccounting inputs;
  for (int ms = 0; ms <= received + 100; ms += 20) {
    while (const LaneEstimate* lanes = perception.advance(at(ms))) inputs = lanes->inputs;
    perception.add(motion(ms));
    perception.add(vehicles(ms + 1, ms + 1));
    if (ms == received || (twice && ms == 0)) perception.add(vehicles(0, ms));
  }
  const LaneEstimate* lanes = perception.advance(at(received + 200));
  EXPECT_NE(lanes, nullptr);
  return inputs;
}

TEST(ReorderWindow, DropsWhatComesLater) {
  EXPECT_EQ(fate_of_late_list(0.2, 120, false), (InputAccounting{11, 0, 0}));
  EXPECT_EQ(fate_of_late_list(0.2, 300, false), (InputAccounting{10, 0, 1}));
  EXPECT_EQ(fate_of_late_list(0.5, 300, false), (InputAccounting{11, 0, 0}));
}

TEST(ReorderWindow, KnowsForAsLongWhatItHasSeen) {
  EXPECT_EQ(fate_of_late_list(2, 1500, false), (InputAccounting{11, 0, 0}));
  EXPECT_EQ(fate_of_late_list(2, 1500, true), (InputAccounting{10, 0, 1}));
}

TEST(CycleClock, SaysWhatTheCarDid) {
  MultiLanePerception perception(at_10_hz(), {});
  for (int ms = 0; ms <= 100; ms += 10) perception.add(VehicleMotion{{at(ms), at(ms), 0}, 25.0, 0.1});
  const LaneEstimate* lanes = perception.advance(at(101));
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
  perception.advance(at(101));
  EXPECT_THAT(stages,
              ::testing::ElementsAre(Stage::sources, Stage::association, Stage::solve, Stage::lane_model));
}

TEST(CycleClock, StepsOverAHoleInsteadOfFillingIt) {
  MultiLanePerception perception(at_10_hz(), {});
  perception.add(motion(0));
  const int day = 24 * 3600 * 1000;
  EXPECT_LT(cycles_until(perception, day).size(), 3U);
}

TEST(CycleClock, DropsWhatAClockThatJumpedBackStamps) {
  MultiLanePerception perception(at_10_hz(), {});
  perception.add(motion(60'000));
  perception.add(motion(0));
  const LaneEstimate* lanes = perception.advance(at(60'200));
  ASSERT_NE(lanes, nullptr);
  EXPECT_EQ(lanes->inputs, (InputAccounting{1, 0, 1}));
}

}  // namespace
}  // namespace lanefuse
