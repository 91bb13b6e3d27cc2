// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "allocation/steady_drive.hpp"
#include "pipeline/graph_estimator.hpp"

namespace lanefuse {
namespace {

/// The whole of a cycle behind the sources: association, graph, lane model, output.
void expect_no_allocation(const LaneModelConfig& lanes) {
  GraphEstimator estimator(FusionConfig{}, lanes);
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
  EXPECT_GT(estimator.debug().switches.size(), 10U);
  EXPECT_EQ(of_all, 0U);
}

TEST(GraphEstimator, AllocatesNothingInSteadyState) { expect_no_allocation({}); }

TEST(GraphEstimator, AllocatesNothingInSteadyStateWithTheJointFit) {
  LaneModelConfig lanes;
  lanes.base.fit = BaseFit::joint;
  expect_no_allocation(lanes);
}

}  // namespace
}  // namespace lanefuse
