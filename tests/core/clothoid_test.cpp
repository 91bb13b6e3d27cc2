// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clothoid.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/pose2.hpp"
#include "support/random_values.hpp"

namespace lanefuse {
namespace {

using testing::between;

/// As motorways are: radii from 500 m up, seen from a car that may be a lane or two off and a little askew.
Clothoid any_clothoid() {
  return {*between(-8, 8), *between(-0.05, 0.05), *between(-2e-3, 2e-3), *between(-1e-5, 1e-5)};
}

TEST(Clothoid, FollowsTheClosedForm) {
  const Clothoid clothoid{2, 0.1, 1e-2, 6e-4};
  EXPECT_DOUBLE_EQ(clothoid.y(0), 2);
  EXPECT_DOUBLE_EQ(clothoid.y(10), 2 + 1 + 0.5 + 0.1);
  EXPECT_DOUBLE_EQ(clothoid.slope(10), 0.1 + 0.1 + 0.03);
  EXPECT_DOUBLE_EQ(clothoid.curvature_at(10), 0.016);
  EXPECT_DOUBLE_EQ(clothoid.heading_at(10), std::atan(0.23));
  EXPECT_DOUBLE_EQ(clothoid.y(-10), 2 - 1 + 0.5 - 0.1);
}

TEST(Clothoid, ComesBackFromItsVector) {
  const Clothoid clothoid{2, 0.1, 1e-2, 6e-4};
  EXPECT_EQ(clothoid.vector(), Eigen::Vector4d(2, 0.1, 1e-2, 6e-4));
  EXPECT_EQ(Clothoid::from_vector(clothoid.vector()), clothoid);
}

RC_GTEST_PROP(Clothoid, JacobiansAreFiniteDifferences, ()) {
  const Eigen::Vector4d start = any_clothoid().vector();
  const double x = *between(-10, 120);
  for (int i = 0; i < 4; ++i) {
    Eigen::Vector4d moved = start;
    moved[i] += 1;  // y and slope are linear in the parameters: any step will do
    const Clothoid before = Clothoid::from_vector(start);
    const Clothoid after = Clothoid::from_vector(moved);
    const double scale = 1 + std::abs(lateral_jacobian(x)[i]);
    RC_ASSERT(std::abs(after.y(x) - before.y(x) - lateral_jacobian(x)[i]) < 1e-9 * scale);
    RC_ASSERT(std::abs(after.slope(x) - before.slope(x) - slope_jacobian(x)[i]) < 1e-9 * scale);
  }
}

RC_GTEST_PROP(Clothoid, SlopeIsTheDerivativeOfY, ()) {
  const Clothoid clothoid = any_clothoid();
  const double x = *between(-10, 120);
  const double h = 1e-3;
  RC_ASSERT(std::abs((clothoid.y(x + h) - clothoid.y(x - h)) / (2 * h) - clothoid.slope(x)) < 1e-8);
  RC_ASSERT(std::abs((clothoid.slope(x + h) - clothoid.slope(x - h)) / (2 * h) - clothoid.curvature_at(x)) <
            1e-8);
}

TEST(TransformClothoid, LeavesItAsItIsWithoutMotion) {
  const Clothoid clothoid{2, 0.1, 1e-2, 6e-4};
  const Clothoid moved = transform(clothoid, {});
  EXPECT_LT((moved.vector() - clothoid.vector()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TransformClothoid, ShiftsAndSlidesExactly) {
  const Clothoid clothoid{2, 0.02, 1e-3, 1e-6};
  EXPECT_NEAR(transform(clothoid, {0, 0.5, 0}).lateral_offset, 1.5, 1e-12);
  const Clothoid slid = transform(clothoid, {20, 0, 0});
  for (const double x : {0.0, 30.0, 80.0}) EXPECT_NEAR(slid.y(x), clothoid.y(x + 20), 1e-12);
}

RC_GTEST_PROP(TransformClothoid, KeepsTheCurveInTheWorldOverACyclesMotion, ()) {
  const Clothoid in_old = any_clothoid();
  const Pose2 old_from_new{*between(0, 6), *between(-0.3, 0.3), *between(-0.02, 0.02)};
  const Clothoid in_new = transform(in_old, old_from_new);
  for (double x = 0; x <= 60; x += 20) {
    const Eigen::Vector2d in_world = old_from_new * Eigen::Vector2d(x, in_new.y(x));
    // What the cubic itself loses in a turned frame: (3/2) theta^2 c0 x^2 / 2 and the like, some millimetres.
    RC_ASSERT(std::abs(in_world.y() - in_old.y(in_world.x())) < 0.002 + 0.02 * x / 60);
  }
  const Eigen::Vector2d origin = old_from_new * Eigen::Vector2d(0, in_new.lateral_offset);
  RC_ASSERT(std::abs(origin.y() - in_old.y(origin.x())) < 1e-9);
}

RC_GTEST_PROP(TransformClothoid, GoesThereAndBack, ()) {
  const Clothoid clothoid = any_clothoid();
  const Pose2 motion{*between(0, 6), *between(-0.3, 0.3), *between(-0.02, 0.02)};
  const Clothoid back = transform(transform(clothoid, motion), motion.inverse());
  RC_ASSERT(std::abs(back.lateral_offset - clothoid.lateral_offset) < 2e-3);
  RC_ASSERT(std::abs(back.heading - clothoid.heading) < 2e-3);
  RC_ASSERT(std::abs(back.curvature - clothoid.curvature) < 1e-5);
}

}  // namespace
}  // namespace lanefuse
