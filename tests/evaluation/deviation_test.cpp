// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/deviation.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lanefuse {
namespace {

DeviationStatistics statistics_of(const std::vector<double>& deviations) {
  DeviationAccumulator accumulator;
  for (const double deviation : deviations) accumulator.add(deviation);
  return accumulator.statistics(50);
}

TEST(DeviationAccumulator, SaysNothingWhereNothingWasJudged) {
  const DeviationStatistics statistics = statistics_of({});
  EXPECT_EQ(statistics.n, 0U);
  EXPECT_TRUE(std::isnan(statistics.mean_m));
  EXPECT_TRUE(std::isnan(statistics.rmse_m));
  EXPECT_TRUE(std::isnan(statistics.p95_m));
  EXPECT_TRUE(std::isnan(statistics.availability));
}

TEST(DeviationAccumulator, GivesTheFiguresOfAKnownSample) {
  const DeviationStatistics statistics = statistics_of({-1, 0, 1, 4});
  EXPECT_DOUBLE_EQ(statistics.distance_m, 50);
  EXPECT_DOUBLE_EQ(statistics.mean_m, 1);
  EXPECT_DOUBLE_EQ(statistics.sigma_m, std::sqrt(3.5));
  EXPECT_DOUBLE_EQ(statistics.rmse_m, std::sqrt(4.5));
  EXPECT_EQ(statistics.n, 4U);
}

TEST(DeviationAccumulator, AConstantDeviationIsItsOwnP95) {
  const DeviationStatistics statistics = statistics_of(std::vector<double>(40, -0.5));
  EXPECT_DOUBLE_EQ(statistics.mean_m, -0.5);
  EXPECT_DOUBLE_EQ(statistics.sigma_m, 0);
  EXPECT_DOUBLE_EQ(statistics.rmse_m, 0.5);
  EXPECT_DOUBLE_EQ(statistics.p95_m, 0.5);
}

TEST(DeviationAccumulator, CountsWhatTheEstimateDidNotReach) {
  DeviationAccumulator accumulator;
  accumulator.add(0.1);
  accumulator.add(std::nullopt);
  accumulator.add(std::nullopt);
  accumulator.add(0.3);
  const DeviationStatistics statistics = accumulator.statistics(0);
  EXPECT_DOUBLE_EQ(statistics.availability, 0.5);
  EXPECT_EQ(statistics.n, 2U);
  EXPECT_DOUBLE_EQ(statistics.mean_m, 0.2);
}

rc::Gen<std::vector<double>> deviations() {
  return rc::gen::container<std::vector<double>>(
      rc::gen::map(rc::gen::inRange(-20000, 20000), [](int millimetres) { return millimetres * 1e-3; }));
}

RC_GTEST_PROP(DeviationAccumulator, P95IsTheNearestRankToHalfAPercent, ()) {
  std::vector<double> sample = *rc::gen::nonEmpty(deviations());
  const double p95 = statistics_of(sample).p95_m;
  for (double& deviation : sample) deviation = std::abs(deviation);
  std::sort(sample.begin(), sample.end());
  const double exact =
      sample[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(sample.size()))) - 1];
  RC_ASSERT(std::abs(p95 - exact) <= 1e-3 + 0.0051 * exact);
}

RC_GTEST_PROP(DeviationAccumulator, PartsMergeIntoTheWhole, ()) {
  const std::vector<double> sample = *deviations();
  const auto cut = static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(sample.size()) + 1));
  DeviationAccumulator whole, first, second;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const auto deviation = i % 3 == 2 ? std::nullopt : std::optional(sample[i]);
    whole.add(deviation);
    (i < cut ? first : second).add(deviation);
  }
  first.merge(second);
  const DeviationStatistics expected = whole.statistics(0);
  const DeviationStatistics merged = first.statistics(0);
  RC_ASSERT(merged.n == expected.n);
  RC_ASSERT(sample.empty() || merged.availability == expected.availability);
  if (expected.n == 0) return;
  RC_ASSERT(std::abs(merged.mean_m - expected.mean_m) < 1e-9);
  RC_ASSERT(std::abs(merged.sigma_m - expected.sigma_m) < 1e-6);
  RC_ASSERT(merged.p95_m == expected.p95_m);
}

TEST(DeviationByDistance, KeepsTheDistancesApart) {
  DeviationByDistance at_every_distance, other;
  at_every_distance.add(0, 0.1);
  other.add(12, -0.4);
  at_every_distance.merge(other);
  const auto statistics = at_every_distance.statistics();
  ASSERT_EQ(statistics.size(), kDistanceCount);
  EXPECT_DOUBLE_EQ(statistics[0].mean_m, 0.1);
  EXPECT_DOUBLE_EQ(statistics[12].distance_m, 120);
  EXPECT_DOUBLE_EQ(statistics[12].mean_m, -0.4);
  EXPECT_EQ(statistics[6].n, 0U);
}

}  // namespace
}  // namespace lanefuse
