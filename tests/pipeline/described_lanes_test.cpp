// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/simulated_run.hpp"

namespace lanefuse {
namespace {

TEST(DescribedLanes, ComeWithEveryCycle) {
  const auto estimates = testing::perceive(testing::simulate({1, 0.6}));
  std::size_t described = 0;
  for (const LaneEstimate& estimate : estimates) {
    for (const Lane& lane : estimate.lanes) {
      const Boundary* left = find_boundary(estimate, lane.left_boundary);
      const Boundary* right = find_boundary(estimate, lane.right_boundary);
      ASSERT_TRUE(left && right);
      EXPECT_LE(lane.range_end, std::min(left->range_end, right->range_end));
      EXPECT_GE(lane.availability, 0);
      EXPECT_LE(lane.availability, 1);
      for (const LanePoint& point : lane.centre) {
        ++described;
        EXPECT_NEAR(point.y, (lateral_at(*left, point.x) + lateral_at(*right, point.x)) / 2, 1e-9);
        EXPECT_NEAR(point.width, 3.6, 0.8);
        EXPECT_LT(std::abs(point.curvature), 0.01);
        EXPECT_GT(point.sigma, 0);
      }
    }
  }
  EXPECT_GT(described, 20 * estimates.size()) << "two lanes to 100 m, at least";
  const Lane* ego = ego_lane(estimates.back());
  ASSERT_NE(ego, nullptr);
  EXPECT_GT(ego->availability, 0.95);
}

TEST(DescribedLanes, AreAvailableAnewAfterAReset) {
  const testing::SimulatedDrive drive = testing::short_drive();
  MultiLanePerception perception({}, drive.rig);
  const auto first = testing::perceive(perception, drive.measurements);
  perception.reset();
  const auto second = testing::perceive(perception, drive.measurements);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].lanes.size(), second[i].lanes.size());
    for (std::size_t l = 0; l < first[i].lanes.size(); ++l)
      EXPECT_EQ(first[i].lanes[l].availability, second[i].lanes[l].availability);
  }
}

}  // namespace
}  // namespace lanefuse
