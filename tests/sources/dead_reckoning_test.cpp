// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/dead_reckoning.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

Time at(double seconds) { return Time{std::chrono::seconds(100) + from_seconds(seconds)}; }

VehicleMotion motion(double seconds, std::optional<double> speed, std::optional<double> yaw_rate) {
  return {{at(seconds), at(seconds), 0}, speed, yaw_rate, {}};
}

Pose2 pose_after(const DeadReckoning& reckoning) {
  return reckoning.samples().front().odometry_from_vehicle.inverse() *
         reckoning.samples().back().odometry_from_vehicle;
}

constexpr InputAccounting kUsed{1, 0, 0};
constexpr InputAccounting kDropped{0, 0, 1};

TEST(DeadReckoning, NeedsSpeedAndYawRateBoth) {
  DeadReckoning reckoning({});
  EXPECT_EQ(reckoning.add(motion(0, 30.0, {})), kUsed);
  EXPECT_TRUE(reckoning.samples().empty());
  EXPECT_EQ(reckoning.add(motion(0.01, {}, 0.1)), kUsed);
  ASSERT_EQ(reckoning.samples().size(), 1U);
  EXPECT_EQ(reckoning.samples()[0].speed, 30);
  EXPECT_EQ(reckoning.samples()[0].yaw_rate, 0.1);
}

TEST(DeadReckoning, DrivesStraightAndOnArcsExactly) {
  for (const double yaw_rate : {0.0, 0.05, -0.3}) {
    DeadReckoning reckoning({});
    for (int i = 0; i <= 100; ++i) reckoning.add(motion(0.02 * i, 25.0, yaw_rate));
    const Pose2 expected = constant_turn(25, yaw_rate, 2);
    EXPECT_NEAR(pose_after(reckoning).x, expected.x, 1e-9);
    EXPECT_NEAR(pose_after(reckoning).y, expected.y, 1e-9);
    EXPECT_NEAR(pose_after(reckoning).heading, expected.heading, 1e-9);
  }
}

TEST(DeadReckoning, TakesTheMeanOfAChangingSpeed) {
  DeadReckoning reckoning({});
  for (int i = 0; i <= 50; ++i) reckoning.add(motion(0.02 * i, 20 + 0.1 * i, 0.0));
  EXPECT_NEAR(pose_after(reckoning).x, 22.5, 1e-9);
}

TEST(DeadReckoning, MixesMessagesOfDifferentRates) {
  DeadReckoning reckoning({});
  for (int i = 0; i <= 200; ++i) {
    if (i % 10 == 0) reckoning.add(motion(0.01 * i, 30.0, {}));
    reckoning.add(motion(0.01 * i, {}, 0.1));
  }
  const Pose2 expected = constant_turn(30, 0.1, 2);
  EXPECT_NEAR(pose_after(reckoning).x, expected.x, 1e-9);
  EXPECT_NEAR(pose_after(reckoning).y, expected.y, 1e-9);
  EXPECT_EQ(reckoning.samples().size(), 201U) << "two messages of one stamp make one sample";
}

TEST(DeadReckoning, DropsWhatComesFromBehindThePathsEnd) {
  DeadReckoning reckoning({});
  reckoning.add(motion(0, 30.0, 0.0));
  reckoning.add(motion(0.1, 30.0, 0.0));
  EXPECT_EQ(reckoning.add(motion(0.05, 99.0, 1.0)), kDropped);
  EXPECT_EQ(reckoning.samples().back().speed, 30);
  EXPECT_EQ(reckoning.add(motion(0.1, 32.0, 0.0)), kUsed) << "the same stamp corrects";
  ASSERT_EQ(reckoning.samples().size(), 2U);
  EXPECT_EQ(reckoning.samples().back().speed, 32);
  EXPECT_NEAR(pose_after(reckoning).x, 3, 1e-9);
}

TEST(DeadReckoning, StartsAnewAfterAGapAndCountsIt) {
  DeadReckoning reckoning({});
  for (int i = 0; i < 10; ++i) reckoning.add(motion(0.1 * i, 30.0, 0.0));
  reckoning.add(motion(1.39, 30.0, 0.0));
  EXPECT_EQ(reckoning.restarts(), 0U) << "0.49 s are no gap";
  reckoning.add(motion(1.91, 30.0, 0.0));
  EXPECT_EQ(reckoning.restarts(), 1U);
  ASSERT_EQ(reckoning.samples().size(), 1U);
  EXPECT_EQ(reckoning.samples()[0].odometry_from_vehicle, Pose2{});
}

TEST(DeadReckoning, KeepsItsHistoryAndNoMore) {
  DeadReckoning reckoning({});
  std::size_t most = 0;
  for (int i = 0; i < 100'000; ++i) {
    reckoning.add(motion(0.01 * i, 30.0, 0.0));
    most = std::max(most, reckoning.samples().size());
  }
  EXPECT_LT(most, 1000U);
  EXPECT_LE(reckoning.samples().front().time, at(999.99 - 3)) << "late measurements still find their pose";
}

TEST(DeadReckoning, SubtractsTheBiasThatStandingStillShows) {
  DeadReckoning reckoning({});
  for (int i = 0; i < 500; ++i) reckoning.add(motion(0.01 * i, 0.0, 0.008));
  EXPECT_NEAR(reckoning.yaw_rate_bias(), 0.008, 1e-4);
  reckoning.add(motion(5, 10.0, 0.108));
  EXPECT_NEAR(reckoning.samples().back().yaw_rate, 0.1, 1e-4);
}

TEST(DeadReckoning, ResetIsABeginning) {
  DeadReckoning reckoning({});
  reckoning.add(motion(0, 0.0, 0.01));
  reckoning.add(motion(5, 0.0, 0.01));
  reckoning.reset();
  EXPECT_TRUE(reckoning.samples().empty());
  EXPECT_EQ(reckoning.restarts(), 0U);
  EXPECT_EQ(reckoning.yaw_rate_bias(), 0);
  reckoning.add(motion(-50, 30.0, {}));
  EXPECT_TRUE(reckoning.samples().empty()) << "the old yaw rate is forgotten";
}

}  // namespace
}  // namespace lanefuse
