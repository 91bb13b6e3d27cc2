// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Roads seen without an error must be found without one.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "road/noiseless_drive.hpp"
#include "road/road_estimator.hpp"

namespace lanefuse {
namespace {

using testing::kLane;
using testing::NoiselessDrive;

/// The largest error of the boundaries that should be there, to `range`.
double worst_error(const LaneEstimate& estimate, const NoiselessDrive& drive, double range) {
  double worst = 0;
  for (const NoiselessDrive::Line& line : drive.lines) {
    for (double x = 2; x <= range; x += 7) {
      const double lateral = drive.lateral_of(line.offset, x);
      const Boundary* boundary = NoiselessDrive::along(estimate, x, lateral);
      if (!boundary) return 1e9;
      worst = std::max(worst, std::abs(lateral_at(*boundary, x) - lateral));
    }
  }
  return worst;
}

class ExactRoad : public ::testing::TestWithParam<double> {};

TEST_P(ExactRoad, IsFoundToACentimetre) {
  NoiselessDrive drive(GetParam());
  drive.paint_three_lanes();
  RoadEstimator estimator{RoadConfig{}};
  const LaneEstimate& estimate = drive.run(estimator, 10);
  EXPECT_EQ(estimate.status, EstimateStatus::ok);
  ASSERT_EQ(estimate.boundaries.size(), 4U);
  ASSERT_EQ(estimate.lanes.size(), 3U);
  EXPECT_LT(worst_error(estimate, drive, 100), 0.015);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GT(estimate.boundaries[i].range_end, 100);
    EXPECT_NEAR(estimate.boundaries[i].clothoid.lateral_offset, kLane * (1.5 - static_cast<double>(i)), 0.03);
    EXPECT_GT(estimate.boundaries[i].support[static_cast<std::size_t>(Source::high_resolution_camera)], 20);
    for (const BoundaryPoint& point : estimate.boundaries[i].points) {
      EXPECT_GT(point.sigma, 0);
      EXPECT_GE(point.protection, 3 * point.sigma);
    }
  }
  const Lane* ego = ego_lane(estimate);
  ASSERT_NE(ego, nullptr);
  EXPECT_EQ(ego->id, estimate.lanes[1].id);
  EXPECT_EQ(ego->left_lane, estimate.lanes[0].id);
  EXPECT_EQ(ego->right_lane, estimate.lanes[2].id);
}

INSTANTIATE_TEST_SUITE_P(Curvatures, ExactRoad, ::testing::Values(0, 1.0 / 2000, -1.0 / 1000, 1.0 / 600));

TEST(RoadEstimator, FindsTheLinesWithinASecond) {
  NoiselessDrive drive;
  drive.paint_three_lanes();
  RoadEstimator estimator{RoadConfig{}};
  drive.advance();
  EXPECT_EQ(estimator.process(drive.cycle()).reason, StatusReason::warming_up);
  EXPECT_EQ(drive.run(estimator, 1).lanes.size(), 3U);
}

TEST(RoadEstimator, ResetForgetsEverything) {
  const auto lanes_of = [](RoadEstimator& estimator) {
    NoiselessDrive drive(1e-3);
    drive.paint_three_lanes();
    drive.vehicles = {{5, 40, [](double) { return kLane; }}};
    return drive.run(estimator, 3);
  };
  RoadEstimator fresh{RoadConfig{}};
  const LaneEstimate first = lanes_of(fresh);
  RoadEstimator used{RoadConfig{}};
  NoiselessDrive other(-5e-4);
  other.paint(1.5);
  other.paint(-2);
  other.vehicles = {{9, 30, [](double) { return -5.0; }}};
  other.run(used, 4.2);
  used.reset();
  const LaneEstimate again = lanes_of(used);
  ASSERT_EQ(again.boundaries.size(), first.boundaries.size());
  for (std::size_t i = 0; i < first.boundaries.size(); ++i) {
    EXPECT_EQ(again.boundaries[i].id, first.boundaries[i].id);
    EXPECT_EQ(again.boundaries[i].clothoid, first.boundaries[i].clothoid);
    EXPECT_EQ(again.boundaries[i].confidence, first.boundaries[i].confidence);
  }
  ASSERT_EQ(again.lanes.size(), first.lanes.size());
  for (std::size_t i = 0; i < first.lanes.size(); ++i) EXPECT_EQ(again.lanes[i].id, first.lanes[i].id);
}

TEST(RoadEstimator, KeepsTheNamesThroughTheCarsLaneChange) {
  NoiselessDrive drive(5e-4);
  drive.paint_three_lanes();
  drive.own = [](double seconds) {
    const double phase = std::clamp((seconds - 3) / 5, 0.0, 1.0);
    return kLane * (1 - std::cos(std::numbers::pi * phase)) / 2;
  };
  RoadEstimator estimator{RoadConfig{}};
  const LaneEstimate before = drive.run(estimator, 3);
  ASSERT_EQ(before.lanes.size(), 3U);
  const std::uint64_t own = ego_lane(before)->id;
  while (drive.seconds() < 9) {
    const LaneEstimate& estimate = drive.run(estimator, 0.04);
    ASSERT_EQ(estimate.lanes.size(), 3U) << drive.seconds();
    for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(estimate.lanes[i].id, before.lanes[i].id);
    ASSERT_LT(worst_error(estimate, drive, 80), 0.05) << drive.seconds();
  }
  EXPECT_EQ(before.lanes[1].id, own);
  drive.advance();
  const Lane* ego = ego_lane(estimator.process(drive.cycle()));
  EXPECT_EQ(ego->id, before.lanes[0].id);
  EXPECT_EQ(ego->left_lane, std::nullopt);
  EXPECT_EQ(ego->right_lane, own);
}

TEST(RoadEstimator, FollowsALineThatLeaves) {
  NoiselessDrive drive;
  drive.paint_three_lanes();
  // The right edge goes off with an exit; the road's own edge begins where it has left.
  constexpr double kExit = 350;
  drive.lines.back().offset = [](double station) {
    return -1.5 * kLane - 0.04 * std::clamp(station - kExit, 0.0, 400.0);
  };
  RoadEstimator estimator{RoadConfig{}};
  while (drive.station() < kExit + 60) {
    const LaneEstimate& estimate = drive.run(estimator, 0.04);
    if (drive.station() < 150) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double x : {5.0, 30.0, 60.0, 90.0}) {
        const double lateral = drive.lateral_of(drive.lines[i].offset, x);
        const Boundary* boundary = NoiselessDrive::along(estimate, x, lateral);
        ASSERT_NE(boundary, nullptr) << i << " at " << x << " after " << drive.station();
        ASSERT_NEAR(lateral_at(*boundary, x), lateral, 0.05 + 3.5e-5 * x * x)
            << i << " at " << x << " after " << drive.station();
      }
    }
    if (drive.station() < kExit + 10 || drive.station() > kExit + 25) continue;
    const RoadState& state = estimator.state();
    const double leaving = drive.lateral_of(drive.lines[3].offset, 15);
    EXPECT_TRUE(std::any_of(state.lines().begin(), state.lines().end(), [&](const KnownLine& line) {
      return std::abs(state.offset(line, 15) - leaving) < 0.4;
    })) << drive.station();
  }
}

class GuardRail : public ::testing::TestWithParam<double> {};

/// Radars and cameras see rails as lines: beside the edge there is no lane.
TEST_P(GuardRail, BoundsNoLane) {
  NoiselessDrive drive;
  drive.paint_three_lanes();
  drive.paint(-1.5 * kLane - GetParam() * kLane, {MarkingType::guard_rail, MarkingColour::unknown});
  RoadEstimator estimator{RoadConfig{}};
  const LaneEstimate& estimate = drive.run(estimator, 8);
  ASSERT_EQ(estimate.lanes.size(), 3U);
  EXPECT_EQ(estimate.boundaries.size(), 4U);
  EXPECT_NEAR(lateral_at(estimate.boundaries.back(), 20), -1.5 * kLane, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Widths, GuardRail, ::testing::Values(0.3, 0.5, 0.7, 0.8));

TEST(RoadEstimator, YellowPaintMakesTheWhiteVoid) {
  NoiselessDrive drive;
  const MarkingEvidence white{MarkingType::solid, MarkingColour::white};
  const MarkingEvidence yellow{MarkingType::solid, MarkingColour::yellow};
  for (const double offset : {1.5, 0.5, -0.5, -1.5}) drive.paint(offset * kLane, white);
  for (const double offset : {1.5, 0.5, -0.5, -1.5}) drive.paint(offset * kLane + 1.2, yellow);
  RoadEstimator estimator{RoadConfig{}};
  const LaneEstimate& estimate = drive.run(estimator, 6);
  ASSERT_EQ(estimate.lanes.size(), 3U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(lateral_at(estimate.boundaries[i], 40), kLane * (1.5 - static_cast<double>(i)) + 1.2, 0.03);
    EXPECT_EQ(estimate.boundaries[i].marking.colour, MarkingColour::yellow);
  }
}

TEST(RoadEstimator, StrayPaintDoesNotMoveALineWithoutPaint) {
  NoiselessDrive drive;
  drive.paint_three_lanes();
  RoadEstimator estimator{RoadConfig{}};
  drive.run(estimator, 4);
  // From here on one line has no paint; now and then there is something beside it.
  drive.lines[2].end = drive.station();
  Random random(2, "strays");
  for (int cycle = 0; cycle < 250; ++cycle) {
    drive.advance();
    if (random.chance(0.8)) {
      const Pose2 place{random.uniform(10, 80), -0.5 * kLane + random.uniform(0.2, 0.6), 0};
      drive.sets().front().features.push_back(NoiselessDrive::feature(place));
    }
    const LaneEstimate& estimate = estimator.process(drive.cycle());
    ASSERT_EQ(estimate.lanes.size(), 3U) << drive.seconds();
    ASSERT_NEAR(lateral_at(estimate.boundaries[2], 10), -0.5 * kLane, 0.15) << drive.seconds();
    ASSERT_NEAR(lateral_at(estimate.boundaries[1], 60), 0.5 * kLane, 0.03) << drive.seconds();
  }
}

TEST(RoadEstimator, BeginsAnewWhereItHasLostTheRoad) {
  NoiselessDrive drive;
  drive.paint_three_lanes();
  RoadEstimator estimator{RoadConfig{}};
  drive.run(estimator, 4);
  // As after a wrong first look: all lines are half a lane from where they are thought to be.
  drive.lines.clear();
  for (const double offset : {2.0, 1.0, 0.0, -1.0}) drive.paint(offset * kLane);
  const LaneEstimate& estimate = drive.run(estimator, 3);
  ASSERT_EQ(estimate.lanes.size(), 3U);
  EXPECT_LT(worst_error(estimate, drive, 60), 0.05);
}

TEST(RoadEstimator, BeginsAnewAfterAJumpOfItsPath) {
  NoiselessDrive drive;
  drive.paint_three_lanes();
  RoadEstimator estimator{RoadConfig{}};
  drive.run(estimator, 3);
  drive.advance();
  drive.motion() = {{drive.now(), {5000, 300, 1}, 30, 0}};
  EXPECT_EQ(estimator.process(drive.cycle()).status, EstimateStatus::invalid);
}

}  // namespace
}  // namespace lanefuse
