// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/feature_fusion.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/fusion_drive.hpp"

namespace lanefuse {
namespace {

using testing::feature_at;
using testing::FusionDrive;

/// Features of a road, far enough from each other to be told apart, as seen from the car.
std::vector<Feature> seen_from(const Pose2& car, const std::vector<Pose2>& places) {
  std::vector<Feature> features;
  for (const Pose2& place : places) {
    const Pose2 seen = car.inverse() * place;
    if (seen.x > 0 && seen.x < 60) features.push_back(feature_at(seen));
  }
  return features;
}

std::vector<Pose2> road_places() {
  std::vector<Pose2> places;
  for (int i = 0; i < 40; ++i) {
    for (const double y : {-1.8, 1.7, 5.3}) places.push_back({3.0 * i, y + 0.01 * i, 0.02});
  }
  return places;
}

/// How far the fused features are from the nearest of the places they stand for, at most.
double farthest_off(const FeatureFusion& fusion, const Pose2& car, const std::vector<Pose2>& places) {
  double farthest = 0;
  for (const Feature& feature : fusion.fused()) {
    const Pose2 place = car * Pose2{feature.x, feature.y, feature.heading};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Pose2& truth : places) {
      const Pose2 off = truth.inverse() * place;
      nearest = std::min(nearest, Eigen::Vector3d(off.x, off.y, off.heading).norm());
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

RC_GTEST_PROP(FeatureFusion, RecoversTheRoadFromAnyNoiselessDrive, ()) {
  const Pose2 start{*rc::gen::inRange(-5, 5) * 0.1, *rc::gen::inRange(-10, 10) * 0.1, 0};
  const auto turns = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(-4, 5));
  const std::vector<Pose2> places = road_places();
  FusionDrive drive;
  Pose2 car = start;
  for (const int turn : turns) {
    car = car * constant_turn(30, turn * 0.02, 0.04);
    RC_ASSERT(drive.step(car, {drive.set(Source::user, seen_from(car, places))}).solve.ok());
  }
  RC_ASSERT(drive.fusion().fused().size() > 40);
  RC_ASSERT(drive.fusion().fused().size() <= 3 * 29);  // each place once
  RC_ASSERT(farthest_off(drive.fusion(), car, places) < 1e-6);
}

TEST(FeatureFusion, TiesALateSetToThePoseOfItsOwnStamp) {
  const std::vector<Pose2> places = road_places();
  const auto car_at = [](double seconds) { return constant_turn(30, 0.2, seconds); };
  FusionDrive drive;
  constexpr double kLate = 0.1;
  for (int cycle = 1; cycle <= 30; ++cycle) {
    const double now = 0.04 * cycle;
    FeatureSet set = drive.set(Source::user, seen_from(car_at(now - kLate), places));
    set.measured_at -= from_seconds(kLate);
    // Before the first motion nobody knows where the car was.
    drive.step(car_at(now), cycle > 3 ? std::vector{set} : std::vector<FeatureSet>{});
  }
  const testing::WindowView view = drive.view();
  const auto measurements = view.edges_of(testing::EdgeKind::measurement);
  ASSERT_GT(measurements.size(), 200U);
  for (const std::size_t edge : measurements) EXPECT_LT(view.error_of(edge).norm(), 1e-6);
  EXPECT_LT(farthest_off(drive.fusion(), car_at(1.2), places), 1e-6);
}

TEST(FeatureFusion, DropsWhatIsOlderThanTheMotionItKnows) {
  FusionDrive drive;
  FeatureSet set = drive.set(Source::user, {feature_at({10, 0, 0}), feature_at({20, 0, 0})});
  set.measured_at -= std::chrono::seconds(5);
  EXPECT_EQ(drive.step({}, {set}).features, (InputAccounting{0, 0, 2}));
}

TEST(FeatureFusion, DoesNothingWithoutMotion) {
  const FusionConfig config;
  FeatureFusion fusion(config, std::make_unique<ConjugateGradientSolver>());
  EXPECT_FALSE(fusion.process({}, [](Stage) {}).has_motion);
  EXPECT_EQ(fusion.size().poses, 0U);
}

TEST(FeatureFusion, RejectsTheImpossibleAndLivesOn) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Feature> bad(7, feature_at({10, 0, 0}));
  bad[0].x = kNan;
  bad[1].heading = std::numeric_limits<double>::infinity();
  bad[2].y = 1e200;
  bad[3].confidence = kNan;
  bad[4].covariance.setZero();
  bad[5].covariance(0, 1) = bad[5].covariance(1, 0) = 5;  // positive on the diagonal, but not definite
  bad[6].covariance(2, 2) = kNan;
  bad.push_back(feature_at({20, 0, 0}));
  FusionDrive drive;
  const FusionResult result = drive.step({}, {drive.set(Source::user, bad)});
  EXPECT_EQ(result.features, (InputAccounting{1, 7, 0}));
  EXPECT_TRUE(result.solve.ok());
  EXPECT_EQ(drive.fusion().fused().size(), 1U);
}

TEST(FeatureFusion, BoundsAWildClothoid) {
  FusionDrive drive;
  FeatureSet set = drive.set(Source::serial_camera, {});
  ClothoidMeasurement wild;
  wild.covariance *= 1e-4;
  wild.range_begin = -1e18;
  wild.range_end = 1e18;
  set.clothoids.push_back(wild);
  wild.range_end = std::numeric_limits<double>::infinity();
  set.clothoids.push_back(wild);
  const FusionResult result = drive.step({}, {set});
  EXPECT_EQ(result.features.rejected, 1U);
  EXPECT_LE(result.features.used, 100U);
}

TEST(FeatureFusion, CountsWhatAFullWindowCannotHold) {
  FusionConfig config;
  config.max_features = 5;
  std::vector<Feature> features;
  for (int i = 0; i < 8; ++i) features.push_back(feature_at({5.0 + 5 * i, 0, 0}));
  FusionDrive drive(config);
  for (int cycle = 0; cycle < 3; ++cycle) {
    EXPECT_EQ(drive.step({}, {drive.set(Source::user, features)}).features, (InputAccounting{5, 0, 3}));
    EXPECT_EQ(drive.fusion().fused().size(), 5U);
  }
}

TEST(FeatureFusion, GrowsConfidentWithEveryWitness) {
  FusionDrive drive;
  drive.step({}, {drive.set(Source::user, {feature_at({10, 0, 0})})});
  EXPECT_NEAR(drive.fusion().fused()[0].confidence, 0.3 * 0.6, 1e-12);
  drive.step({}, {drive.set(Source::user, {feature_at({10, 0, 0})}, 7)});
  EXPECT_NEAR(drive.fusion().fused()[0].confidence, 1 - 0.82 * 0.82, 1e-12) << "another sensor";
  drive.step({3, 0, 0}, {drive.set(Source::user, {feature_at({7, 0, 0})})});
  EXPECT_NEAR(drive.fusion().fused()[0].confidence, 1 - 0.82 * 0.82 * 0.82, 1e-12) << "another place";
}

TEST(FeatureFusion, GrowsNoMoreConfidentByLookingAgainFromTheSamePlace) {
  FusionDrive drive;
  for (int cycle = 0; cycle < 20; ++cycle) {
    drive.step({}, {drive.set(Source::user, {feature_at({10, 0, 0})})});
    EXPECT_NEAR(drive.fusion().fused()[0].confidence, 0.3 * 0.6, 1e-12);
  }
}

TEST(FeatureFusion, TellsHowWellAFeatureWasMeasured) {
  FusionDrive drive;
  const Feature turned = feature_at({30, 5, 0.5}, 0.2, 0.02);
  drive.step({}, {drive.set(Source::user, {turned}, 1), drive.set(Source::user, {turned}, 2)});
  const Eigen::Matrix3d own = rotate_covariance(drive.fusion().fused()[0].covariance, -0.5);
  EXPECT_NEAR(own(1, 1), 0.04 / 2, 1e-9) << "two sensors of 0.2 m";
  EXPECT_NEAR(own(2, 2), 4e-4 / 2, 1e-9);
}

TEST(FeatureFusion, GivesTheSameBytesForTheSameCycles) {
  const std::vector<Pose2> places = road_places();
  FusionDrive once, again;
  const auto run = [&](FusionDrive& drive) {
    for (int i = 0; i < 30; ++i) {
      const Pose2 car = constant_turn(30, 0.1, 0.04 * i);
      drive.step(car, {drive.set(Source::user, seen_from(car, places))});
    }
    std::vector<double> numbers;
    for (const Feature& f : drive.fusion().fused()) {
      numbers.insert(numbers.end(), {f.x, f.y, f.heading, f.confidence});
      numbers.insert(numbers.end(), f.covariance.data(), f.covariance.data() + 9);
    }
    return numbers;
  };
  const auto first = run(once);
  ASSERT_FALSE(first.empty());
  EXPECT_EQ(first, run(again));
  once.restart();
  EXPECT_TRUE(once.fusion().fused().empty());
  EXPECT_EQ(once.fusion().size().edges, 0U);
  EXPECT_EQ(first, run(once)) << "as after construction";
}

}  // namespace
}  // namespace lanefuse
