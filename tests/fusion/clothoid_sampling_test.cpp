// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/clothoid_sampling.hpp"

#include <cmath>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace lanefuse {
namespace {

ClothoidMeasurement measured_marking() {
  ClothoidMeasurement marking;
  marking.clothoid = {1.8, 0.02, 2e-3, -1e-5};
  const Eigen::Vector4d sigma(0.2, 0.02, 1e-3, 2e-5);
  Eigen::Matrix4d correlation = Eigen::Matrix4d::Constant(0.3);
  correlation.diagonal().setOnes();
  marking.covariance = sigma.asDiagonal() * correlation * sigma.asDiagonal();
  marking.range_begin = 4;
  marking.range_end = 60;
  marking.confidence = 0.8;
  marking.marking.type = MarkingType::dashed;
  return marking;
}

std::vector<Feature> samples(const ClothoidMeasurement& marking, double spacing = 2) {
  std::vector<Feature> features;
  sample_clothoid(marking, spacing, features);
  return features;
}

TEST(ClothoidSampling, StandsOnTheClothoidFromEndToEnd) {
  const auto marking = measured_marking();
  const auto features = samples(marking);
  ASSERT_EQ(features.size(), 29U);
  for (std::size_t i = 0; i < features.size(); ++i) {
    const double x = 4 + 2 * static_cast<double>(i);
    EXPECT_DOUBLE_EQ(features[i].x, x);
    EXPECT_DOUBLE_EQ(features[i].y, marking.clothoid.y(x));
    EXPECT_NEAR(std::tan(features[i].heading), marking.clothoid.slope(x), 1e-12);
    EXPECT_EQ(features[i].marking, marking.marking);
  }
}

TEST(ClothoidSampling, AppendsToWhatIsThereAndMindsTheSpacing) {
  std::vector<Feature> features(3);
  sample_clothoid(measured_marking(), 8, features);
  EXPECT_EQ(features.size(), 3U + 8U);
}

TEST(ClothoidSampling, BringsNothingForAnEmptyRange) {
  auto marking = measured_marking();
  marking.range_end = 3;
  EXPECT_TRUE(samples(marking).empty());
}

TEST(ClothoidSampling, LosesConfidenceWithTheDistance) {
  const auto features = samples(measured_marking());
  EXPECT_NEAR(features.front().confidence, 0.8 * std::exp(-4.0 / 60), 1e-12);
  EXPECT_NEAR(features.back().confidence, 0.8 * std::exp(-1.0), 1e-12);
}

/// Variances of y and of the heading at each sample, over clothoids drawn from the measurement's
/// distribution.
std::vector<Eigen::Array2d> drawn_variances(const ClothoidMeasurement& marking, int draws) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const Eigen::Matrix4d root = marking.covariance.llt().matrixL();
  const auto mean = samples(marking);
  std::vector<Eigen::Array2d> sums(mean.size(), Eigen::Array2d::Zero());
  for (int draw = 0; draw < draws; ++draw) {
    Eigen::Vector4d white;
    for (double& w : white) w = normal(random);
    const Clothoid drawn = Clothoid::from_vector(marking.clothoid.vector() + root * white);
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const Eigen::Array2d off(drawn.y(mean[i].x) - mean[i].y, drawn.heading_at(mean[i].x) - mean[i].heading);
      sums[i] += off * off / draws;
    }
  }
  return sums;
}

TEST(ClothoidSampling, CarriesTheClothoidsOwnUncertainty) {
  const auto marking = measured_marking();
  const auto features = samples(marking);
  const auto variances = drawn_variances(marking, 20000);
  for (std::size_t i = 0; i < features.size(); ++i) {
    EXPECT_NEAR(features[i].covariance(1, 1) / variances[i][0], 1, 0.06) << features[i].x;
    EXPECT_NEAR(features[i].covariance(2, 2) / variances[i][1], 1, 0.06) << features[i].x;
  }
}

TEST(ClothoidSampling, BelievesNoCameraBeyondItsCalibration) {
  auto marking = measured_marking();
  marking.covariance.setZero();
  for (const Feature& feature : samples(marking)) {
    EXPECT_NEAR(std::sqrt(feature.covariance(1, 1)), 0.03, 1e-12);
    EXPECT_NEAR(std::sqrt(feature.covariance(2, 2)), 0.003, 1e-12);
  }
}

}  // namespace
}  // namespace lanefuse
