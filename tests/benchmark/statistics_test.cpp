// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "benchmark/drive_statistics.hpp"
#include "benchmark/student_t.hpp"
#include "core/random.hpp"

namespace lanefuse {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(StudentT, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(two_sided_quantile(0.95, 1), 12.70620, 1e-4);
  EXPECT_NEAR(two_sided_quantile(0.95, 2), 4.30265, 1e-5);
  EXPECT_NEAR(two_sided_quantile(0.95, 5), 2.57058, 1e-5);
  EXPECT_NEAR(two_sided_quantile(0.95, 30), 2.04227, 1e-5);
  EXPECT_NEAR(two_sided_quantile(0.99, 10), 3.16927, 1e-5);
  EXPECT_NEAR(two_sided_quantile(0.95, 1e7), 1.95996, 1e-5);
}

TEST(StudentT, ProbabilitiesAreThoseOfTheIntegral) {
  EXPECT_NEAR(two_sided_probability(1, 1), 0.5, 1e-12);
  EXPECT_NEAR(two_sided_probability(2, 10), 0.07338803477, 1e-10);
  EXPECT_NEAR(two_sided_probability(-3, 4), 0.03994196807, 1e-10);
  EXPECT_NEAR(two_sided_probability(2.5, 3.7), 0.07182202291, 1e-10);
  EXPECT_EQ(two_sided_probability(0, 3), 1);
  EXPECT_EQ(two_sided_probability(HUGE_VAL, 3), 0);
}

RC_GTEST_PROP(StudentT, QuantileAndProbabilityAreInverse, ()) {
  const double freedom = *rc::gen::inRange(1, 400) / 2.0 + 0.5;
  const double share = *rc::gen::inRange(1, 1000) / 1000.0;
  RC_ASSERT(std::abs(two_sided_probability(two_sided_quantile(share, freedom), freedom) - (1 - share)) <
            1e-9);
}

TEST(Holm, CorrectsStepByStep) {
  EXPECT_THAT(holm(std::vector{0.01, 0.04, 0.03, 0.005}),
              ElementsAre(DoubleNear(0.03, 1e-12), DoubleNear(0.06, 1e-12), DoubleNear(0.06, 1e-12),
                          DoubleNear(0.02, 1e-12)));
  EXPECT_THAT(holm({}), IsEmpty());
  EXPECT_THAT(holm(std::vector{0.9, 0.8}), ElementsAre(1, 1));
}

RC_GTEST_PROP(Holm, NeverMakesLikelierThanOneNorLessLikelyThanBefore, (const std::vector<unsigned>& raw)) {
  std::vector<double> probabilities;
  for (const unsigned value : raw) probabilities.push_back((value % 1000) / 1000.0);
  const std::vector<double> corrected = holm(probabilities);
  for (std::size_t i = 0; i < corrected.size(); ++i) {
    RC_ASSERT(corrected[i] >= probabilities[i]);
    RC_ASSERT(corrected[i] <= 1);
  }
}

TEST(MeanOfDrives, HasTheIntervalOfStudentsT) {
  // Mean 3, sigma 1.5811: 2.7764 * 1.5811 / sqrt(5).
  const auto mean = mean_of_drives(std::vector<DriveSample>{{1, 7}, {2, 7}, {3, 7}, {4, 7}, {5, 7}});
  ASSERT_TRUE(mean && mean->half_width);
  EXPECT_DOUBLE_EQ(mean->mean, 3);
  EXPECT_NEAR(*mean->half_width, 1.96324, 1e-5);
  EXPECT_EQ(mean->drives, 5U);
}

TEST(MeanOfDrives, WeighsByJudgements) {
  const auto mean = mean_of_drives(std::vector<DriveSample>{{1, 300}, {5, 100}});
  ASSERT_TRUE(mean);
  EXPECT_DOUBLE_EQ(mean->mean, 2);
}

TEST(MeanOfDrives, OneDriveHasNoIntervalAndNoneNoMean) {
  EXPECT_FALSE(mean_of_drives({}));
  EXPECT_FALSE(mean_of_drives(std::vector<DriveSample>{{1, 1}})->half_width);
}

TEST(PairedDifference, IsTheOneSampleTest) {
  // Mean 2, sigma 1, n 4: t = 4 with 3 degrees of freedom (p 0.02801).
  const double s = std::sqrt(1.5);
  const Difference difference = paired_difference(std::vector{2 - s, 2.0, 2.0, 2 + s});
  EXPECT_DOUBLE_EQ(difference.mean, 2);
  ASSERT_TRUE(difference.half_width && difference.probability);
  EXPECT_NEAR(*difference.half_width, 3.18245 / 2, 1e-5);
  EXPECT_NEAR(*difference.probability, 0.02801, 1e-5);
}

TEST(PairedDifference, EqualDifferencesLeaveNoDoubt) {
  EXPECT_EQ(paired_difference(std::vector{0.0, 0.0}).probability, 1);
  EXPECT_EQ(paired_difference(std::vector{0.5, 0.5}).probability, 0);
  EXPECT_FALSE(paired_difference(std::vector{0.5}).probability);
}

TEST(UnpairedDifference, IsWelchsTest) {
  const Difference difference =
      unpaired_difference(std::vector{3.0, 4.0, 5.5, 6.0}, std::vector{7.0, 6.5, 9.0, 8.5, 7.5});
  EXPECT_NEAR(difference.mean, 3.075, 1e-12);
  EXPECT_NEAR(difference.probability.value(), 0.0117677868, 1e-9);
}

TEST(UnpairedDifference, OfASingleDriveSaysNoMore) {
  EXPECT_FALSE(unpaired_difference(std::vector{1.0}, std::vector{2.0, 3.0}).probability);
}

TEST(RatioOfMeans, WeighsEachSideByItsOwn) {
  const PairedSample samples[] = {{{1, 1}, {4, 2}}, {{4, 2}, {1, 1}}};
  const auto ratio = ratio_of_means(samples);
  ASSERT_TRUE(ratio && ratio->factor);
  EXPECT_DOUBLE_EQ(ratio->ratio, 1);
  EXPECT_GT(*ratio->factor, 1);
}

TEST(RatioOfMeans, WhatBothSidesOfADriveShareIsGone) {
  const PairedSample hard_and_easy[] = {{{2, 10}, {1, 10}}, {{20, 10}, {10, 10}}, {{6, 10}, {3, 10}}};
  const auto ratio = ratio_of_means(hard_and_easy);
  ASSERT_TRUE(ratio && ratio->factor);
  EXPECT_DOUBLE_EQ(ratio->ratio, 2);
  EXPECT_NEAR(*ratio->factor, 1, 1e-9);
}

TEST(RatioOfMeans, OneDriveGivesNoInterval) {
  const PairedSample one[] = {{{2, 10}, {1, 10}}};
  ASSERT_TRUE(ratio_of_means(one));
  EXPECT_FALSE(ratio_of_means(one)->factor);
  EXPECT_FALSE(ratio_of_means({}));
  const PairedSample nothing_under[] = {{{2, 10}, {0, 10}}};
  EXPECT_FALSE(ratio_of_means(nothing_under));
}

/// The interval is what it says: over many repetitions it holds the true ratio 95 times in a hundred.
TEST(RatioOfMeans, CoversTheTrueRatio) {
  Random random(7, "ratio of means");
  int held = 0;
  constexpr int kRepetitions = 2000;
  for (int i = 0; i < kRepetitions; ++i) {
    std::vector<PairedSample> samples;
    for (int drive = 0; drive < 24; ++drive) {
      const double shared = random.normal(0.2);
      samples.push_back({{2 * std::exp(shared + random.normal(0.2)), random.uniform(50, 150)},
                         {std::exp(shared + random.normal(0.2)), random.uniform(50, 150)}});
    }
    const auto ratio = ratio_of_means(samples);
    held += 2 > ratio->ratio / *ratio->factor && 2 < ratio->ratio * *ratio->factor;
  }
  EXPECT_NEAR(double(held) / kRepetitions, 0.95, 0.02);
}

}  // namespace
}  // namespace lanefuse
