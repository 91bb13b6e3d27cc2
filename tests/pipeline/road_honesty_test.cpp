// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// One drive shows no share to the point, but whether sigmas are of the right size. The shares over many
// drives are in docs/road.md.
#include <gtest/gtest.h>

#include "support/simulated_run.hpp"

namespace lanefuse {
namespace {

/// Two kilometres of the nominal preset, by the road-level estimator.
const EvaluationResult& judged_drive() {
  static const EvaluationResult result = [] {
    PerceptionConfig config;
    config.estimator = EstimatorKind::road;
    const testing::SimulatedDrive drive = testing::simulate({31, 2});
    return testing::judge(drive, testing::perceive(drive, config));
  }();
  return result;
}

TEST(RoadHonesty, ErrorsAreOfTheSizeThatIsTold) {
  const EvaluationResult& result = judged_drive();
  const double nees = mean_normalised_square(result.consistency);
  EXPECT_GT(nees, 0.3);
  EXPECT_LT(nees, 3);
  for (const ConsistencyStatistics& at : result.consistency.ego) {
    if (at.n < 200) continue;
    EXPECT_GT(at.mean_normalised_square, 0.1) << at.distance_m;
    EXPECT_LT(at.mean_normalised_square, 6) << at.distance_m;
    EXPECT_GT(at.within_99, 0.85) << at.distance_m;
  }
}

TEST(RoadHonesty, ErrorsStayInsideTheirProtectionLevels) {
  std::uint64_t judged = 0;
  for (const ConsistencyStatistics& at : judged_drive().consistency.ego) {
    judged += at.n_protected;
    if (at.n_protected == 0) continue;
    EXPECT_LT(at.misleading_rate, 0.01) << at.distance_m;
  }
  EXPECT_GT(judged, 5000U);
}

TEST(RoadHonesty, TheRoadIsWhereItIsSaidToBe) {
  const EvaluationResult& result = judged_drive();
  EXPECT_EQ(result.cycles_in_wrong_lane, 0U);
  EXPECT_LT(false_lanes_per_cycle(result), 0.02);
  EXPECT_GT(static_cast<double>(result.cycles_ok) / static_cast<double>(result.cycles), 0.95);
  EXPECT_EQ(result.resets, 0U);
  const auto most = [](double distance) { return distance <= 20 ? 0.06 : distance <= 60 ? 0.2 : 0.64; };
  for (const DeviationStatistics& at : result.lanes.ego) {
    if (at.n == 0) continue;
    EXPECT_LT(at.rmse_m, most(at.distance_m)) << at.distance_m << " m: twice what is demanded";
  }
}

}  // namespace
}  // namespace lanefuse
