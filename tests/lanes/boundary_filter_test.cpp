// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/boundary_filter.hpp"

#include <cmath>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lanefuse {
namespace {

const LaneModelConfig kConfig;

BoundaryFit fit_of(const Clothoid& clothoid, double sigma = 0.01) {
  BoundaryFit fit{clothoid, {}};
  fit.covariance = Eigen::Vector4d(sigma, sigma / 100, sigma / 1e4, sigma / 1e6).cwiseAbs2().asDiagonal();
  return fit;
}

double lateral_sigma(const BoundaryFilter& filter, double x) {
  return std::sqrt(lateral_jacobian(x) * filter.covariance() * lateral_jacobian(x).transpose());
}

RC_GTEST_PROP(BoundaryFilter, CarriesAStraightLineThroughAnyMotion, ()) {
  const Clothoid line{1.8, 0.03, 0, 0};
  BoundaryFilter filter(1, fit_of(line), kConfig);
  Pose2 car;
  for (const int turn : *rc::gen::container<std::vector<int>>(50, rc::gen::inRange(-3, 4))) {
    const Pose2 step = constant_turn(30, turn * 0.01, 0.04);
    filter.predict(step);
    car = car * step;
  }
  for (const double x : {0.0, 20.0, 80.0}) {
    const Eigen::Vector2d in_start = car * Eigen::Vector2d(x, filter.clothoid().y(x));
    RC_ASSERT(std::abs(in_start.y() - line.y(in_start.x())) < 1e-6);
  }
}

RC_GTEST_PROP(BoundaryFilter, CarriesABendAlongItsOwnWay, ()) {
  const double curvature = *rc::gen::inRange(-10, 11) * 1e-4;
  BoundaryFilter filter(1, fit_of({1.8, 0, curvature, 0}), kConfig);
  for (int i = 0; i < 50; ++i) filter.predict(constant_turn(30, 30 * curvature, 0.04));
  // The car follows the bend: it looks the same from everywhere.
  RC_ASSERT(std::abs(filter.clothoid().y(0) - 1.8) < 0.02);
  RC_ASSERT(std::abs(filter.clothoid().slope(0)) < 2e-3);
  RC_ASSERT(std::abs(filter.clothoid().curvature - curvature) < 1e-12);
}

TEST(BoundaryFilter, LetsTheCurvatureRateDriveNothing) {
  BoundaryFilter filter(1, fit_of({1.8, 0, 1e-3, 1e-5}), kConfig);
  for (int i = 0; i < 50; ++i) filter.predict({1.2, 0, 0});
  EXPECT_NEAR(filter.clothoid().curvature, 1e-3, 1e-12);
  EXPECT_NEAR(filter.clothoid().curvature_rate, 1e-5, 1e-15);
}

TEST(BoundaryFilter, GetsNoDoubtFromStandingStill) {
  BoundaryFilter filter(1, fit_of({1.8, 0.01, 1e-3, 1e-6}), kConfig);
  const Eigen::Matrix4d before = filter.covariance();
  for (int i = 0; i < 1000; ++i) filter.predict({});
  EXPECT_TRUE(filter.covariance().isApprox(before, 1e-12));
  EXPECT_NEAR(filter.clothoid().lateral_offset, 1.8, 1e-9);
  EXPECT_NEAR(filter.clothoid().heading, 0.01, 1e-9);
}

TEST(BoundaryFilter, DoubtsMoreTheFurtherItIsCarried) {
  BoundaryFilter filter(1, fit_of({1.8, 0, 0, 0}), kConfig);
  const double before = lateral_sigma(filter, 60);
  for (int i = 0; i < 50; ++i) filter.predict({1.2, 0, 0});
  EXPECT_GT(lateral_sigma(filter, 60), before);
}

TEST(BoundaryFilter, ComesToWhatItIsToldAgainAndAgain) {
  BoundaryFilter filter(1, fit_of({1.0, 0, 0, 0}), kConfig);
  const Clothoid truth{1.8, 0.01, 5e-4, 1e-6};
  for (int i = 0; i < 300; ++i) filter.update(fit_of(truth));
  EXPECT_LT((filter.clothoid().vector() - truth.vector()).cwiseAbs()[0], 0.01);
  EXPECT_NEAR(filter.clothoid().curvature, truth.curvature, 1e-5);
  EXPECT_EQ(filter.covariance().llt().info(), Eigen::Success);
}

TEST(BoundaryFilter, HeedsASureFitMoreThanAnUnsureOne) {
  BoundaryFilter sure(1, fit_of({1.0, 0, 0, 0}), kConfig);
  BoundaryFilter unsure = sure;
  sure.update(fit_of({1.8, 0, 0, 0}, 0.01));
  unsure.update(fit_of({1.8, 0, 0, 0}, 1));
  EXPECT_GT(sure.clothoid().lateral_offset, unsure.clothoid().lateral_offset + 0.1);
}

}  // namespace
}  // namespace lanefuse
