// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/simulated_run.hpp"

namespace lanefuse {
namespace {

/// What two simulated kilometres come to with some of the sensors [IROS16, sec. III and Table I]. Everything
/// is deterministic; the margins are for those who tune, and half of what is measured or wider.
class SensorContribution : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  static EvaluationResult result_with(bool high_resolution_camera, bool serial_camera, bool objects) {
    const SimulationConfig config{GetParam(), 2, RoadKind::gentle, serial_camera, high_resolution_camera,
                                  objects};
    const testing::SimulatedDrive drive = testing::simulate(config);
    return testing::judge(drive, testing::perceive(drive));
  }
  /// The entry of so many metres ahead.
  static const DeviationStatistics& at(const std::vector<DeviationStatistics>& statistics,
                                       std::size_t metres) {
    return statistics[metres / 10];
  }
};

TEST_P(SensorContribution, AllTogetherSeeTheEgoLaneAndItsNeighboursAlmostAlways) {
  const EvaluationResult all = result_with(true, true, true);
  EXPECT_GT(all.cycles, 750U);
  EXPECT_GE(at(all.lanes.ego, 60).availability, 0.95);
  EXPECT_GE(at(all.lanes.adjacent, 60).availability, 0.95);
  EXPECT_LT(at(all.lanes.ego, 0).rmse_m, 0.1);
  EXPECT_LT(at(all.lanes.ego, 60).rmse_m, 0.3);
  EXPECT_LT(at(all.lanes.ego, 120).rmse_m, 0.8);
  EXPECT_LT(at(all.lanes.adjacent, 60).rmse_m, 0.5);
  EXPECT_LT(wrong_lane_rate(all), 0.01);
  EXPECT_GE(static_cast<double>(all.cycles_ok), 0.95 * static_cast<double>(all.cycles));
}

TEST_P(SensorContribution, TheHighResolutionCameraShowsNeighbours) {
  const EvaluationResult all = result_with(true, true, true);
  const EvaluationResult without = result_with(false, true, true);
  EXPECT_LT(at(without.lanes.adjacent, 60).availability, at(all.lanes.adjacent, 60).availability - 0.15);
  EXPECT_GE(at(without.lanes.ego, 60).availability, 0.95) << "the serial camera still sees the ego lane";
}

TEST_P(SensorContribution, VehiclesAloneTellOfLanesButCoarsely) {
  const EvaluationResult all = result_with(true, true, true);
  const EvaluationResult serial = result_with(false, true, true);
  const EvaluationResult alone = result_with(false, false, true);
  EXPECT_GT(at(alone.lanes.ego, 60).availability, 0.3) << "without any camera there are lanes";
  EXPECT_LT(at(alone.lanes.ego, 60).availability, at(serial.lanes.ego, 60).availability - 0.1);
  EXPECT_LT(at(alone.lanes.adjacent, 60).availability, at(serial.lanes.adjacent, 60).availability - 0.03);
  EXPECT_GT(at(alone.lanes.ego, 60).rmse_m, 2 * at(all.lanes.ego, 60).rmse_m);
}

TEST_P(SensorContribution, VehiclesShowTheNeighboursThatTheSerialCameraCannotSee) {
  const EvaluationResult with = result_with(false, true, true);
  const EvaluationResult without = result_with(false, true, false);
  EXPECT_GT(at(with.lanes.adjacent, 60).availability, 0.2);
  EXPECT_LT(at(without.lanes.adjacent, 60).availability, 0.05);
}

TEST_P(SensorContribution, TheSerialCameraPlacesTheEgoLaneNearTheCar) {
  const EvaluationResult all = result_with(true, true, true);
  const EvaluationResult without = result_with(true, false, true);
  EXPECT_GT(at(without.lanes.ego, 0).rmse_m, 1.4 * at(all.lanes.ego, 0).rmse_m);
  EXPECT_GE(at(without.lanes.ego, 60).availability, 0.95) << "the high-resolution camera sees it as well";
}

/// Over some drives, as each has one draw of its camera's yaw bias, which alone may turn the far road either
/// way.
TEST(SensorContributionOverDrives, TheHighResolutionCameraShowsTheRoadFarAhead) {
  const auto square_at_120_m = [](const SimulationConfig& config) {
    const testing::SimulatedDrive drive = testing::simulate(config);
    const double rmse = testing::judge(drive, testing::perceive(drive)).lanes.ego[12].rmse_m;
    return rmse * rmse;
  };
  double all = 0, without = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    SimulationConfig config{seed, 2};
    all += square_at_120_m(config);
    config.high_resolution_camera = false;
    without += square_at_120_m(config);
  }
  EXPECT_GT(std::sqrt(without / all), 1.25);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SensorContribution, ::testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace lanefuse
