// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "allocation/steady_drive.hpp"
#include "pipeline/graph_estimator.hpp"
#include "road/road_estimator.hpp"

namespace lanefuse {
namespace {

/// The whole of a cycle behind the sources: association, estimate, lanes, output.
template <typename Estimator>
void expect_no_allocation(Estimator& estimator) {
  std::vector<MotionSample> motion;
  std::size_t of_all = 0;
  for (int cycle = 0; cycle < 900; ++cycle) {
    const Time now = from_nanoseconds(1'000'000'000) + cycle * std::chrono::milliseconds(40);
    motion.push_back({now, {1.2 * cycle, 0, 0}, 0, 0});
    const std::vector<FeatureSet> sets = testing::sets_at(cycle, now);
    const Cycle input{now, motion, sets};
    const testing::Count count;
    const LaneEstimate& estimate = estimator.process(input);
    if (cycle < 400) continue;
    of_all += count();
    ASSERT_GE(estimate.lanes.size(), 2U);
  }
  EXPECT_EQ(of_all, 0U);
}

TEST(GraphEstimator, AllocatesNothingInSteadyState) {
  GraphEstimator estimator(FusionConfig{}, {});
  expect_no_allocation(estimator);
  EXPECT_GT(estimator.debug().switches.size(), 10U);
}

TEST(GraphEstimator, AllocatesNothingInSteadyStateWithTheJointFit) {
  LaneModelConfig lanes;
  lanes.base.fit = BaseFit::joint;
  GraphEstimator estimator(FusionConfig{}, lanes);
  expect_no_allocation(estimator);
  EXPECT_GT(estimator.debug().switches.size(), 10U);
}

TEST(RoadEstimator, AllocatesNothingInSteadyState) {
  RoadEstimator estimator{RoadConfig{}};
  expect_no_allocation(estimator);
  EXPECT_EQ(estimator.state().lines().size(), 3U);
  EXPECT_EQ(estimator.state().vehicles().size(), 1U);
}

/// Lines and vehicles that come and go, impossible features, a road that was lost: within what it has taken
/// once, nothing more is taken.
TEST(RoadEstimator, AllocatesNothingOnAnUnsteadyDriveOnceItHasSeenAll) {
  RoadEstimator estimator{RoadConfig{}};
  std::vector<MotionSample> motion;
  std::size_t of_second_half = 0;
  constexpr int kRound = 700;
  for (int cycle = 0; cycle < 4 * kRound; ++cycle) {
    const int phase = cycle % kRound;
    const Time now = from_nanoseconds(1'000'000'000) + cycle * std::chrono::milliseconds(40);
    motion.push_back({now, {1.2 * cycle, 0, 0}, 0, 0});
    std::vector<FeatureSet> sets = testing::sets_at(cycle, now);
    FeatureSet& tracked = sets.emplace_back();
    tracked.measured_at = now;
    ClothoidMeasurement& side = tracked.clothoids.emplace_back();
    side.clothoid.lateral_offset = 1.75;
    side.covariance = Eigen::Vector4d(0.03, 0.003, 1e-4, 1e-6).cwiseAbs2().asDiagonal();
    side.range_end = 50;
    side.side = Side::left;
    if (phase % 50 == 0) sets[0].features[7].x = std::nan("");
    for (Feature& feature : sets[0].features) {
      if (phase > 300 && phase < 600) feature.y += 1.75;
    }
    for (Feature& feature : sets[1].features) {
      if (phase % 200 > 100) feature.track_id = phase;
    }
    const Cycle input{now, motion, sets};
    const testing::Count count;
    estimator.process(input);
    if (cycle >= 2 * kRound) of_second_half += count();
  }
  EXPECT_EQ(of_second_half, 0U);
}

}  // namespace
}  // namespace lanefuse
