// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/consistency.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

constexpr int kDraws = 20'000;
constexpr std::size_t kDistance = 6;

/// Deviations that are `truly` times as large as the sigma that they come with, and that sigma differs.
ConsistencyStatistics judged(double truly) {
  Random random(7, "deviations");
  ConsistencyByDistance consistency;
  for (int i = 0; i < kDraws; ++i) {
    const double sigma = i % 2 == 0 ? 0.1 : 0.3;
    consistency.add(kDistance, random.normal(truly * sigma), sigma);
  }
  return consistency.statistics()[kDistance];
}

TEST(Consistency, HonestSigmasCoverWhatTheySay) {
  const ConsistencyStatistics at = judged(1);
  EXPECT_EQ(at.n, static_cast<std::uint64_t>(kDraws));
  EXPECT_NEAR(at.mean_normalised_square, 1, 0.03);
  EXPECT_NEAR(at.within_68, 0.68, 0.01);
  EXPECT_NEAR(at.within_95, 0.95, 0.005);
  EXPECT_NEAR(at.within_99, 0.99, 0.0025);
  EXPECT_NEAR(at.stated_sigma_m, 0.2, 1e-12);
}

TEST(Consistency, SigmasThatAreHalfOrTwiceTheTruthAreSeen) {
  EXPECT_NEAR(judged(2).within_68, 0.381, 0.01);
  EXPECT_NEAR(judged(2).within_95, 0.673, 0.01);
  EXPECT_NEAR(judged(0.5).within_68, 0.953, 0.005);
  EXPECT_NEAR(judged(0.5).mean_normalised_square, 0.25, 0.01);
}

TEST(Consistency, WhoIsBeyondTheProtectionLevelIsMisled) {
  ConsistencyByDistance consistency;
  for (const double deviation : {0.1, -0.49, 0.5, -0.51}) consistency.add_protection(0, deviation, 0.5);
  consistency.add_protection(0, 9, 0);  // nothing vouched for
  consistency.add_protection(0, 0.2, 1.5);
  const ConsistencyStatistics at = consistency.statistics()[0];
  EXPECT_EQ(at.n_protected, 5U);
  EXPECT_DOUBLE_EQ(at.misleading_rate, 0.2);
  EXPECT_DOUBLE_EQ(at.protection_m, 0.7);
  EXPECT_EQ(at.n, 0U) << "no sigma was stated";
  EXPECT_TRUE(std::isnan(at.stated_sigma_m));
  EXPECT_TRUE(std::isnan(consistency.statistics()[1].misleading_rate)) << "nothing vouched for there";
}

TEST(Consistency, PartsMergeIntoTheWhole) {
  ConsistencyByDistance whole;
  ConsistencyByDistance parts[2];
  for (std::size_t i = 0; i < 10; ++i) {
    const double deviation = 0.1 * static_cast<double>(i);
    for (ConsistencyByDistance* one : {&whole, &parts[i % 2]}) {
      one->add(3, deviation, 0.3);
      one->add_protection(3, deviation, 0.65);
    }
  }
  parts[0].merge(parts[1]);
  const ConsistencyStatistics merged = parts[0].statistics()[3];
  const ConsistencyStatistics at = whole.statistics()[3];
  EXPECT_EQ(merged.n, at.n);
  EXPECT_DOUBLE_EQ(merged.mean_normalised_square, at.mean_normalised_square);
  EXPECT_DOUBLE_EQ(merged.within_68, at.within_68);
  EXPECT_DOUBLE_EQ(merged.stated_sigma_m, at.stated_sigma_m);
  EXPECT_DOUBLE_EQ(merged.protection_m, at.protection_m);
  EXPECT_DOUBLE_EQ(merged.misleading_rate, 0.3);
  EXPECT_EQ(merged.n_protected, 10U);
}

}  // namespace
}  // namespace lanefuse
