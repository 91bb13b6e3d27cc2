// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/base_clothoid.hpp"

#include <algorithm>
#include <limits>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lanes/marking_features.hpp"

namespace lanefuse {
namespace {

using testing::features_of;
using testing::parting;
using testing::road_of;
using testing::shaken;

RC_GTEST_PROP(BaseClothoid, IsRecoveredFromExactFeatures, ()) {
  const Clothoid road{0, *rc::gen::inRange(-30, 31) * 1e-3, *rc::gen::inRange(-10, 11) * 1e-4,
                      *rc::gen::inRange(-10, 11) * 1e-6};
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  const auto base = fit.fit(road_of(road, {5.4, 1.8, -1.8}));
  RC_ASSERT(base.has_value());
  RC_ASSERT(base->clothoid.lateral_offset == 0);
  RC_ASSERT(parting(base->clothoid, road) < 0.01);
}

TEST(BaseClothoid, FitsTheTangentOfTheHeading) {
  const Clothoid sharp{0, 0, 1.0 / 300, 0};  // at 90 m the heading is 0.29 and its tangent 0.30
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  const auto base = fit.fit(features_of(sharp, 0, {0, 100, 1}));
  ASSERT_TRUE(base);
  EXPECT_NEAR(base->clothoid.slope(90), 0.3, 1e-3);
}

TEST(BaseClothoid, CutsOutliersThatAreThirtyInAHundred) {
  const Clothoid road{0, 0.01, 5e-4, 0};
  auto features = shaken(road_of(road, {1.8, -1.8}), 0, 0.003, 5);
  const std::size_t good = features.size();
  for (std::size_t i = 0; i < good * 3 / 7; ++i) {
    Feature wrong = features[2 * i % good];
    wrong.heading += i % 4 == 0 ? -0.1 : 0.08 + 1e-3 * static_cast<double>(i);
    features.push_back(wrong);
  }
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  const auto base = fit.fit(features);
  ASSERT_TRUE(base);
  for (std::size_t i = good; i < features.size(); ++i) EXPECT_EQ(fit.roles()[i], FitRole::outlier) << i;
  EXPECT_GE(std::count(fit.roles().begin(), fit.roles().begin() + static_cast<std::ptrdiff_t>(good),
                       FitRole::inlier),
            static_cast<std::ptrdiff_t>(good * 95 / 100));
  EXPECT_LT(parting(base->clothoid, road, 80), 0.2);
}

TEST(BaseClothoid, WeighsFeaturesByTheirConfidence) {
  const Clothoid left{0, 0.010, 0, 0};
  const Clothoid right{0, 0.012, 0, 0};
  auto features = features_of(left, 0, {.confidence = 0.9});
  testing::append(features, features_of(right, 0, {.confidence = 0.1}));
  const BaseClothoidConfig config{.outlier_cut = 100};
  BaseClothoidFit fit(config);
  EXPECT_NEAR(fit.fit(features)->clothoid.heading, 0.0102, 2e-5);
}

TEST(BaseClothoid, NeedsEnoughFeatures) {
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  EXPECT_FALSE(fit.fit({}));
  EXPECT_FALSE(fit.fit(features_of({}, 0, {2, 14, 2})));  // 7
  EXPECT_TRUE(fit.fit(features_of({}, 0, {2, 16, 2})));   // 8
}

TEST(BaseClothoid, LeavesOutWhatIsOutOfRangeOrNoLane) {
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  auto features = features_of({}, 0);
  const std::size_t good = features.size();
  for (int i = 0; i < 6; ++i) features.push_back({20, 0, 0, 0.8});
  features[good + 0].x = -6;
  features[good + 1].x = 136;
  features[good + 2].heading = 0.4;
  features[good + 3].confidence = 0;
  features[good + 4].heading = std::numeric_limits<double>::quiet_NaN();
  features[good + 5].y = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(fit.fit(features));
  for (std::size_t i = 0; i < features.size(); ++i) {
    EXPECT_EQ(fit.roles()[i], i < good ? FitRole::inlier : FitRole::unused) << i;
  }
}

TEST(BaseClothoid, IsNotDrawnToStraightWhereThereIsData) {
  const Clothoid road{0, 0.01, 1.0 / 600, 0};
  const auto features = shaken(road_of(road, {5.4, 1.8, -1.8}), 0, 0.005, 3);
  BaseClothoidConfig free;
  free.curvature_sigma = free.curvature_rate_sigma = 1;
  const BaseClothoidConfig config;
  BaseClothoidFit with_prior(config);
  BaseClothoidFit without_prior(free);
  const auto with = with_prior.fit(features);
  const auto without = without_prior.fit(features);
  ASSERT_TRUE(with && without);
  const double sigma = std::sqrt(with->covariance(1, 1));
  EXPECT_LT(std::abs(with->clothoid.curvature - without->clothoid.curvature), 0.5 * sigma);
}

TEST(BaseClothoid, FallsBackOnThePriorWhereDataIsBlind) {
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  const auto base = fit.fit(shaken(features_of({}, 0, {10, 12, 0.2}), 0, 0.02, 1));  // two metres of road
  ASSERT_TRUE(base);
  EXPECT_LT(std::abs(base->clothoid.curvature), 3 * config.curvature_sigma);
  EXPECT_LT(std::abs(base->clothoid.curvature_rate), 3 * config.curvature_rate_sigma);
}

TEST(BaseClothoidCovariance, IsPositiveDefiniteAndShrinksWithData) {
  BaseClothoidConfig config;
  config.curvature_sigma = config.curvature_rate_sigma = 1;  // data alone
  BaseClothoidFit fit(config);
  const auto mean_covariance = [&](double spacing) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto base = fit.fit(shaken(road_of({}, {1.8, -1.8}, {2, 80, spacing}), 0, 0.01, seed));
      EXPECT_EQ(base->covariance.llt().info(), Eigen::Success);
      EXPECT_TRUE(base->covariance.isApprox(base->covariance.transpose(), 1e-9));
      sum += base->covariance / 20;
    }
    return sum;
  };
  const Eigen::Matrix3d few = mean_covariance(4);
  const Eigen::Matrix3d many = mean_covariance(0.5);  // eight times as many
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(many(i, i), few(i, i) / 4) << i;
    EXPECT_GT(many(i, i), few(i, i) / 16) << i;
  }
}

TEST(BaseClothoidCovariance, NeverExceedsThePrior) {
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto base = fit.fit(shaken(features_of({}, 0, {2, 30, 3}), 0, 0.02, seed));
    EXPECT_LT(std::sqrt(base->covariance(1, 1)), 1.05 * config.curvature_sigma) << seed;
    EXPECT_LT(std::sqrt(base->covariance(2, 2)), 1.05 * config.curvature_rate_sigma) << seed;
  }
}

TEST(BaseClothoidCovariance, TrustsATrailLessThanPaint) {
  const BaseClothoidConfig config;
  BaseClothoidFit fit(config);
  auto features = shaken(features_of({}, 0), 0, 0.01, 2);
  const double paint = fit.fit(features)->covariance(0, 0);
  for (Feature& feature : features) feature.track_id = 4;
  EXPECT_GT(fit.fit(features)->covariance(0, 0), 1.5 * paint);
}

}  // namespace
}  // namespace lanefuse
