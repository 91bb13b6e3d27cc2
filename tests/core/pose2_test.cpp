// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/pose2.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_values.hpp"

namespace lanefuse {
namespace {

using testing::any_pose;
using testing::between;

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool near(const Pose2& a, const Pose2& b, double tolerance = 1e-9) {
  return (a.position() - b.position()).norm() < tolerance &&
         std::abs(wrap_angle(a.heading - b.heading)) < tolerance;
}

TEST(WrapAngle, LeavesWhatLiesInTheIntervalUntouched) {
  for (const double angle : {0.0, 1.0, -3.0, -kPi, std::nextafter(kPi, 0.0)})
    EXPECT_EQ(wrap_angle(angle), angle);
}

TEST(WrapAngle, TakesPiToItsLowerEnd) {
  EXPECT_EQ(wrap_angle(kPi), -kPi);
  EXPECT_EQ(wrap_angle(3 * kPi), -kPi);
  EXPECT_EQ(wrap_angle(-3 * kPi), -kPi);
  EXPECT_NEAR(wrap_angle(std::nextafter(-kPi, -4.0)), kPi, 1e-9);
}

TEST(WrapAngle, LeavesNonFiniteAnglesAsTheyAre) {
  EXPECT_EQ(wrap_angle(kInfinity), kInfinity);
  EXPECT_EQ(wrap_angle(-kInfinity), -kInfinity);
  EXPECT_TRUE(std::isnan(wrap_angle(std::nan(""))));
}

RC_GTEST_PROP(WrapAngle, KeepsTheDirectionOfAnyAngle, ()) {
  const double angle = *between(-1e4, 1e4);
  const double wrapped = wrap_angle(angle);
  RC_ASSERT(wrapped >= -kPi);
  RC_ASSERT(wrapped < kPi);
  RC_ASSERT(std::abs(std::sin(wrapped) - std::sin(angle)) < 1e-9);
  RC_ASSERT(std::abs(std::cos(wrapped) - std::cos(angle)) < 1e-9);
}

TEST(WrapAngle, KeepsTheIntervalForHugeAngles) {
  for (const double angle : {1e9, -1e15, 1e100, -1e308}) {
    EXPECT_GE(wrap_angle(angle), -kPi);
    EXPECT_LT(wrap_angle(angle), kPi);
  }
}

RC_GTEST_PROP(Pose2, IsAGroup, ()) {
  const Pose2 a = any_pose();
  const Pose2 b = any_pose();
  const Pose2 c = any_pose();
  RC_ASSERT(near((a * b) * c, a * (b * c)));
  RC_ASSERT(near(a * Pose2{}, a));
  RC_ASSERT(near(Pose2{} * a, a));
  RC_ASSERT(near(a * a.inverse(), {}));
  RC_ASSERT(near(a.inverse() * a, {}));
  RC_ASSERT(near((a * b).inverse(), b.inverse() * a.inverse()));
}

RC_GTEST_PROP(Pose2, MovesPointsAsItsProductsDo, ()) {
  const Pose2 a = any_pose();
  const Pose2 b = any_pose();
  const Eigen::Vector2d point = any_pose().position();
  RC_ASSERT((((a * b) * point) - (a * (b * point))).norm() < 1e-9);
}

TEST(Pose2, TurnsLeftForPositiveHeadings) {
  const Pose2 world_from_vehicle{10, 20, kPi / 2};
  const Eigen::Vector2d ahead = world_from_vehicle * Eigen::Vector2d(5, 1);
  EXPECT_NEAR(ahead.x(), 9, 1e-12);
  EXPECT_NEAR(ahead.y(), 25, 1e-12);
}

TEST(RotateCovariance, SwapsTheAxesInAQuarterTurn) {
  Eigen::Matrix3d covariance = Eigen::Vector3d(4, 1, 0.1).asDiagonal();
  covariance(0, 2) = covariance(2, 0) = 0.2;
  const Eigen::Matrix3d turned = rotate_covariance(covariance, kPi / 2);
  EXPECT_NEAR(turned(0, 0), 1, 1e-12);
  EXPECT_NEAR(turned(1, 1), 4, 1e-12);
  EXPECT_NEAR(turned(2, 2), 0.1, 1e-12);
  EXPECT_NEAR(turned(1, 2), 0.2, 1e-12) << "what leaned forward leans to the left";
}

RC_GTEST_PROP(RotateCovariance, KeepsTheUncertaintyOfATurnedDirection, ()) {
  const Eigen::Matrix3d covariance = testing::any_covariance<3>();
  const double angle = *between(-kPi, kPi);
  const Eigen::Vector3d direction(*between(-1, 1), *between(-1, 1), *between(-1, 1));
  Eigen::Vector3d turned = direction;
  turned.head<2>() = rotation(angle) * direction.head<2>();
  const double before = direction.dot(covariance * direction);
  const double after = turned.dot(rotate_covariance(covariance, angle) * turned);
  RC_ASSERT(std::abs(after - before) < 1e-9);
}

}  // namespace
}  // namespace lanefuse
