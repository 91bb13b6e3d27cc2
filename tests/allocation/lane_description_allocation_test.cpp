// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "allocation/steady_drive.hpp"
#include "core/lane_availability.hpp"
#include "core/lane_description.hpp"

namespace lanefuse {
namespace {

TEST(LaneDescription, AllocatesNothingInSteadyState) {
  LaneAvailability availability;
  LaneEstimate estimate;
  estimate.boundaries.resize(4);
  estimate.lanes.resize(3);
  for (std::size_t i = 0; i < estimate.boundaries.size(); ++i) {
    Boundary& boundary = estimate.boundaries[i];
    boundary.id = i;
    boundary.clothoid.lateral_offset = 5.4 - 3.6 * static_cast<double>(i);
    boundary.range_end = 120;
    sample_points(boundary);
    if (i < estimate.lanes.size()) {
      estimate.lanes[i].id = i;
      estimate.lanes[i].left_boundary = i;
      estimate.lanes[i].right_boundary = i + 1;
    }
  }
  std::size_t of_all = 0;
  for (int cycle = 0; cycle < 900; ++cycle) {
    estimate.time = from_nanoseconds(1'000'000'000) + cycle * std::chrono::milliseconds(40);
    const testing::Count count;
    describe_lanes(estimate);
    availability.update(estimate);
    if (cycle >= 400) of_all += count();
  }
  EXPECT_EQ(estimate.lanes.front().centre.size(), 13U);
  EXPECT_DOUBLE_EQ(estimate.lanes.front().availability, 1);
  EXPECT_EQ(of_all, 0U);
}

}  // namespace
}  // namespace lanefuse
