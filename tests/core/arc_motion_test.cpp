// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/motion.hpp"
#include "core/pose2.hpp"
#include "support/random_values.hpp"

namespace lanefuse {
namespace {

using testing::any_pose;
using testing::between;

double distance(const Pose2& a, const Pose2& b) {
  return (a.position() - b.position()).norm() + std::abs(wrap_angle(a.heading - b.heading));
}

/// Many small straight steps, each in the middle of its turn.
Pose2 integrate(double speed, double yaw_rate, double seconds) {
  constexpr int kSteps = 20000;
  const double dt = seconds / kSteps;
  Pose2 pose;
  for (int i = 0; i < kSteps; ++i) {
    const double heading = yaw_rate * (i + 0.5) * dt;
    pose.x += speed * dt * std::cos(heading);
    pose.y += speed * dt * std::sin(heading);
  }
  pose.heading = wrap_angle(yaw_rate * seconds);
  return pose;
}

TEST(ConstantTurn, IsStraightWithoutYawRate) {
  EXPECT_EQ(constant_turn(30, 0, 2), (Pose2{60, 0, 0}));
  EXPECT_EQ(constant_turn(-5, 0, 2), (Pose2{-10, 0, 0}));
}

TEST(ConstantTurn, DrivesASemicircleAndAFullOne) {
  const double yaw_rate = 0.5;
  const double radius = 10 / yaw_rate;
  EXPECT_LT(
      distance(constant_turn(10, yaw_rate, std::numbers::pi / yaw_rate), {0, 2 * radius, std::numbers::pi}),
      1e-9);
  EXPECT_LT(distance(constant_turn(10, yaw_rate, 2 * std::numbers::pi / yaw_rate), {}), 1e-9);
}

TEST(ConstantTurn, HasNoStepWhereItsFormulaChanges) {
  const Pose2 below = constant_turn(30, 1.99e-6, 1);
  const Pose2 above = constant_turn(30, 2.01e-6, 1);
  EXPECT_NEAR(above.x, below.x, 1e-10);
  EXPECT_NEAR(above.y - below.y, 15 * 0.02e-6, 1e-11);
}

RC_GTEST_PROP(ConstantTurn, AgreesWithFineIntegration, ()) {
  const double speed = *between(-40, 60);
  const double yaw_rate = *between(-2, 2);
  const double seconds = *between(0, 3);
  RC_ASSERT(distance(constant_turn(speed, yaw_rate, seconds), integrate(speed, yaw_rate, seconds)) < 1e-5);
}

RC_GTEST_PROP(ConstantTurn, GoesOnWhereItStopped, ()) {
  const double speed = *between(-40, 60);
  const double yaw_rate = *between(-2, 2);
  const double first = *between(0, 2);
  const double second = *between(0, 2);
  const Pose2 both = constant_turn(speed, yaw_rate, first) * constant_turn(speed, yaw_rate, second);
  RC_ASSERT(distance(both, constant_turn(speed, yaw_rate, first + second)) < 1e-8);
}

RC_GTEST_PROP(Interpolate, HitsBothEnds, ()) {
  const Pose2 from = any_pose();
  const Pose2 to = any_pose();
  RC_ASSERT(distance(interpolate(from, to, 0), from) < 1e-9);
  RC_ASSERT(distance(interpolate(from, to, 1), to) < 1e-6);
}

RC_GTEST_PROP(Interpolate, LiesOnTheArcAndGoesOnAlongIt, ()) {
  const Pose2 from = any_pose();
  const double speed = *between(1, 50);
  const double yaw_rate = *between(-2, 2);
  const double fraction = *between(-0.5, 2);
  const Pose2 to = from * constant_turn(speed, yaw_rate, 1);
  const Pose2 on_arc = from * constant_turn(speed, yaw_rate, fraction);
  RC_ASSERT(distance(interpolate(from, to, fraction), on_arc) < 1e-7);
}

class PoseAt : public ::testing::Test {
 protected:
  static Time at(double seconds) { return Time{from_seconds(seconds)}; }
  static Pose2 exact(double seconds) { return start_ * constant_turn(30, 0.1, seconds); }
  static bool ask(double seconds, Pose2& pose) {
    return pose_at(samples_, at(seconds), std::chrono::milliseconds(100), pose);
  }
  static constexpr Pose2 start_{3, 4, 2.5};
  static inline const std::array<MotionSample, 3> samples_{
      MotionSample{at(1.0), start_* constant_turn(30, 0.1, 1.0), 30, 0.1},
      MotionSample{at(1.1), start_* constant_turn(30, 0.1, 1.1), 30, 0.1},
      MotionSample{at(1.4), start_* constant_turn(30, 0.1, 1.4), 30, 0.1}};
};

TEST_F(PoseAt, LiesOnTheArcBetweenSamplesAndAtThem) {
  for (const double seconds : {1.0, 1.03, 1.1, 1.25, 1.399, 1.4}) {
    Pose2 pose;
    ASSERT_TRUE(ask(seconds, pose)) << seconds;
    EXPECT_LT(distance(pose, exact(seconds)), 1e-9) << seconds;
  }
}

TEST_F(PoseAt, ReachesBeyondTheEndsAsFarAsItIsAllowed) {
  for (const double seconds : {0.9, 0.95, 1.45, 1.5}) {
    Pose2 pose;
    ASSERT_TRUE(ask(seconds, pose)) << seconds;
    EXPECT_LT(distance(pose, exact(seconds)), 1e-9) << seconds;
  }
  for (const double seconds : {0.899, 1.501, -100.0, 100.0}) {
    Pose2 pose{1, 2, 3};
    EXPECT_FALSE(ask(seconds, pose)) << seconds;
    EXPECT_EQ(pose, (Pose2{1, 2, 3})) << "a refused pose is not touched";
  }
}

TEST_F(PoseAt, MakesDoWithOneSample) {
  Pose2 pose;
  const std::span<const MotionSample> one(samples_.data(), 1);
  EXPECT_TRUE(pose_at(one, at(1.05), std::chrono::milliseconds(50), pose));
  EXPECT_LT(distance(pose, exact(1.05)), 1e-9);
  EXPECT_FALSE(pose_at(one, at(1.06), std::chrono::milliseconds(50), pose));
}

}  // namespace
}  // namespace lanefuse
