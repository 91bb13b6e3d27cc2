// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/constraints.hpp"

#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/fusion_drive.hpp"

namespace lanefuse {
namespace {

using testing::feature_at;

RC_GTEST_PROP(MeasurementInformation, IsThatOfTheMarkingsOwnFrameWhateverItsHeading, ()) {
  const double heading = *rc::gen::inRange(-314, 314) * 0.01;
  const double across = *rc::gen::inRange(1, 100) * 0.01;
  const Feature feature = feature_at({20, 3, heading}, across, 0.02);
  const Eigen::Vector3d expected(1, 1 / (across * across), 2500);
  RC_ASSERT(measurement_information(feature, 1).isApprox(expected.asDiagonal().toDenseMatrix(), 1e-9));
}

TEST(MeasurementInformation, BelievesNoSensorMoreThanSigmaAlongTheMarking) {
  Feature feature = feature_at({20, 3, 0});
  EXPECT_DOUBLE_EQ(measurement_information(feature, 2)(0, 0), 1.0 / 4);
  feature.covariance(0, 0) = 9;  // but a sensor that doubts itself more is believed in that
  EXPECT_DOUBLE_EQ(measurement_information(feature, 2)(0, 0), 1.0 / 9);
}

TEST(OdometryInformation, ShrinksWithTheWayAndTheTime) {
  const OdometryNoise noise;
  const Eigen::Vector3d near = odometry_information(noise, 2, 0.1).diagonal();
  const Eigen::Vector3d far = odometry_information(noise, 10, 0.1).diagonal();
  const Eigen::Vector3d late = odometry_information(noise, 2, 10).diagonal();
  EXPECT_LT(far[0], near[0]);
  EXPECT_LT(far[1], near[1]);
  EXPECT_EQ(late.head<2>(), near.head<2>()) << "only the gyro errs with time";
  EXPECT_LT(late[2], near[2]);
}

TEST(OdometryInformation, HasTheSigmasOfTheNoiseModel) {
  const OdometryNoise noise{0.01, 0.1, 0.05, 0.002};
  const Eigen::Vector3d sigma = odometry_information(noise, 100, 4).diagonal().cwiseInverse().cwiseSqrt();
  EXPECT_NEAR(sigma[0], 1.0, 0.01);
  EXPECT_NEAR(sigma[1], 0.2, 0.01);
  EXPECT_NEAR(sigma[2] * 180 / std::numbers::pi, std::hypot(0.2, 0.2), 0.02);
}

TEST(OdometryInformation, StaysFiniteWhereTheCarHardlyMoves) {
  EXPECT_TRUE(odometry_information({}, 0, 0).allFinite());
}

TEST(WidthEdge, SaysHowFarTheLeftFeatureIsToTheLeftOfTheRightOne) {
  EXPECT_EQ(width_target({3.4, 0.2}), (Pose2{0, 3.4, 0}));
}

TEST(WidthEdge, TrustsAWidthAsFarAsItIsKnown) {
  FusionConfig config;
  config.width_sigma = 0.3;
  EXPECT_NEAR(width_information({3.5, 0.4}, config)(1, 1), 1 / 0.25, 1e-12);
  EXPECT_GT(width_information({3.5, 0.1}, config)(1, 1), width_information({3.5, 0.4}, config)(1, 1));
}

TEST(Ties, SayNothingAlongTheRoad) {
  const FusionConfig config;
  for (const Eigen::Matrix3d& information :
       {width_information({3.5, 0.2}, config), smoothing_information(config)}) {
    EXPECT_TRUE(information.row(0).isZero(0));
    EXPECT_TRUE(information.col(0).isZero(0));
    EXPECT_GT(information(1, 1), 0);
    EXPECT_GT(information(2, 2), 0);
  }
}

TEST(SmoothingEdge, IsAsStiffAsConfigured) {
  FusionConfig config;
  config.smoothing_sigma = 0.2;
  config.smoothing_heading_deg = 180 / std::numbers::pi;
  const Eigen::Matrix3d information = smoothing_information(config);
  EXPECT_NEAR(information(1, 1), 25, 1e-9);
  EXPECT_NEAR(information(2, 2), 1, 1e-9);
}

}  // namespace
}  // namespace lanefuse
