// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/estimator_ratio.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/summary.hpp"
#include "benchmark/synthetic_results.hpp"

namespace lanefuse {
namespace {

using ::testing::IsEmpty;
using testing::seed;
using ::testing::SizeIs;

/// One drive a value, seeds counted from `first`.
void add_drives(const std::string& estimator, const std::vector<double>& rmse, std::vector<ResultLine>& lines,
                std::uint64_t first = 1) {
  for (std::size_t i = 0; i < rmse.size(); ++i) {
    DriveKey key = seed(first + i);
    key.estimator = estimator;
    lines.push_back(testing::result_line(key, rmse[i]));
  }
}

const std::vector<EstimatorRatio>& ratios_of(const std::string& estimator,
                                             const std::vector<Summary>& summaries) {
  return std::ranges::find(summaries, estimator, &Summary::estimator)->ratios;
}

TEST(EstimatorRatio, IsOfTheRmseOfAllDrivesTogether) {
  std::vector<ResultLine> lines;
  add_drives("graph", {0.3, 0.7}, lines);
  add_drives("oracle", {0.1, 0.1}, lines);
  const auto summaries = summarise(lines, GroupBy::drive_kind);
  const auto& ratios = ratios_of("graph", summaries);
  ASSERT_THAT(ratios, SizeIs(1));
  EXPECT_EQ(ratios[0].to, "oracle");
  EXPECT_EQ(ratios[0].drives, 2U);
  ASSERT_THAT(ratios[0].rmse, SizeIs(2 * kShownDistances));
  for (const auto& mean : ratios[0].rmse) {
    ASSERT_TRUE(mean && mean->low && mean->high);
    EXPECT_NEAR(mean->value, std::sqrt((0.09 + 0.49) / 2) / 0.1, 1e-9);
    EXPECT_NEAR(*mean->low * *mean->high, mean->value * mean->value, 1e-9);
    EXPECT_LT(*mean->low, mean->value);
  }
}

TEST(EstimatorRatio, IsOverTheDrivesThatBothHave) {
  std::vector<ResultLine> lines;
  add_drives("road", {0.2, 0.2, 0.9}, lines);
  add_drives("oracle", {0.1, 0.1}, lines);
  add_drives("oracle", {0.01}, lines, 77);
  const auto ratios = ratios_of("road", summarise(lines, GroupBy::drive_kind));
  ASSERT_THAT(ratios, SizeIs(1));
  EXPECT_EQ(ratios[0].drives, 2U);
  EXPECT_NEAR(ratios[0].rmse[0]->value, 2, 1e-9);
  EXPECT_NEAR(*ratios[0].rmse[0]->low, 2, 1e-9) << "both drives say so";
}

TEST(EstimatorRatio, TheRoadLevelEstimatorIsMeasuredAgainstTheGraphToo) {
  std::vector<ResultLine> lines;
  add_drives("graph", {0.4, 0.4}, lines);
  add_drives("road", {0.2, 0.2}, lines);
  add_drives("oracle", {0.1, 0.1}, lines);
  const auto summaries = summarise(lines, GroupBy::drive_kind);
  const auto& road = ratios_of("road", summaries);
  ASSERT_THAT(road, SizeIs(2));
  EXPECT_EQ(road[1].to, "graph");
  EXPECT_NEAR(road[1].rmse[3]->value, 0.5, 1e-9);
  EXPECT_THAT(ratios_of("graph", summaries), SizeIs(1));
  EXPECT_THAT(ratios_of("oracle", summaries), IsEmpty());
}

TEST(EstimatorRatio, OtherDrivesSayNothing) {
  std::vector<ResultLine> lines;
  add_drives("road", {0.2}, lines);
  for (auto part : {&DriveKey::scene, &DriveKey::road, &DriveKey::variant, &DriveKey::truth}) {
    DriveKey other = seed(1);
    other.estimator = "oracle";
    other.*part = "another";
    lines.push_back(testing::result_line(other, 0.1));
  }
  EXPECT_THAT(ratios_of("road", summarise(lines, GroupBy::drive_kind)), IsEmpty());
}

TEST(EstimatorRatio, WhatEitherLacksHasNone) {
  std::vector<ResultLine> lines;
  add_drives("road", {0.2}, lines);
  add_drives("oracle", {0.1}, lines);
  lines[1].json["lanes"]["ego"][12]["rmse_m"] = nullptr;
  const auto ratios = ratios_of("road", summarise(lines, GroupBy::drive_kind));
  ASSERT_THAT(ratios, SizeIs(1));
  EXPECT_FALSE(ratios[0].rmse[rmse_figure(false, 6)]);
  const auto& near = ratios[0].rmse[rmse_figure(false, 5)];
  ASSERT_TRUE(near);
  EXPECT_EQ(near->drives, 1U);
  EXPECT_FALSE(near->low) << "of one drive";
}

}  // namespace
}  // namespace lanefuse
