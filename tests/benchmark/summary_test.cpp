// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/summary.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/synthetic_results.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

using testing::drives;
using testing::result_line;
using testing::seed;
using ::testing::SizeIs;

TEST(Figures, NamesMatchTheirPlaces) {
  EXPECT_EQ(figures().size(), kFigureCount);
  EXPECT_EQ(figures()[rmse_figure(false, 3)].name, "ego RMSE at 60 m");
  EXPECT_EQ(figures()[rmse_figure(true, 6)].name, "adjacent RMSE at 120 m");
  EXPECT_EQ(figures()[kAdjacentReaches].name, "adjacent reaches 60 m");
  EXPECT_EQ(figures()[kCycleSlow].name, "cycle time, 99th percentile");
}

TEST(Figures, StandWhereLinesHaveThem) {
  const ResultLine line = result_line(seed(1), 0.1);
  EXPECT_DOUBLE_EQ(value_of(figures()[rmse_figure(false, 3)], line.json).value(), 0.7);
  EXPECT_DOUBLE_EQ(value_of(figures()[rmse_figure(true, 0)], line.json).value(), 0.2);
  EXPECT_EQ(value_of(figures()[kWrongLane], line.json), 0);
  EXPECT_FALSE(value_of(figures()[kFalseLanes], line.json)) << "null is no number";
  EXPECT_FALSE(value_of(figures()[kCycleMedian], line.json)) << "not timed";
}

TEST(Summary, PoolsErrorsByTheirMeanSquare) {
  const auto summaries = summarise(drives({0.1, 0.7}), GroupBy::drive_kind);
  ASSERT_THAT(summaries, SizeIs(1));
  const auto& mean = summaries[0].means[rmse_figure(false, 0)];
  ASSERT_TRUE(mean && mean->low && mean->high);
  EXPECT_NEAR(mean->value, std::sqrt((0.01 + 0.49) / 2), 1e-12);
  EXPECT_EQ(*mean->low, 0) << "two drives so unlike say nothing of the least error";
  EXPECT_NEAR(*mean->high, std::sqrt(0.25 + 12.7062 * 0.24), 1e-4);
  EXPECT_EQ(summaries[0].drives, 2U);
  EXPECT_TRUE(summaries[0].nominal);
  EXPECT_FALSE(summaries[0].means[kFalseLanes]);
}

TEST(Summary, WeighsDrivesByTheirDeviations) {
  auto lines = drives({0.1, 0.7});
  lines[1].json["lanes"]["ego"][0]["n"] = 300;
  lines[0].json["lanes"]["ego"][2]["n"] = 0;
  const Summary summary = summarise(lines, GroupBy::drive_kind)[0];
  EXPECT_NEAR(summary.means[rmse_figure(false, 0)]->value, std::sqrt((0.01 + 3 * 0.49) / 4), 1e-12);
  EXPECT_EQ(summary.means[rmse_figure(false, 1)]->drives, 1U) << "nothing was judged on the other";
}

std::vector<ResultLine> two_roads_and_variants() {
  std::vector<ResultLine> lines;
  for (const char* road : {"gentle", "curved"}) {
    for (const char* variant : {"full", "no-width"}) {
      DriveKey key = seed(1);
      key.road = road;
      key.variant = variant;
      lines.push_back(result_line(key, 0.1, {"1", "p", "s", variant}));
    }
  }
  return lines;
}

TEST(Summary, GroupsByWhatIsAskedFor) {
  const auto lines = two_roads_and_variants();
  EXPECT_THAT(summarise(lines, GroupBy::drive_kind), SizeIs(4));
  EXPECT_EQ(summarise(lines, GroupBy::drive_kind)[1].name, "nominal, gentle, no-width");
  EXPECT_EQ(summarise(lines, GroupBy::scene)[0].drives, 4U);
  const auto by_variant = summarise(lines, GroupBy::variant);
  ASSERT_THAT(by_variant, SizeIs(2));
  EXPECT_EQ(by_variant[1].name, "no-width");
  EXPECT_FALSE(by_variant[1].nominal);
  const auto by_road = summarise(lines, GroupBy::road);
  ASSERT_THAT(by_road, SizeIs(2));
  EXPECT_FALSE(by_road[0].nominal) << "ablations are among its drives";
}

TEST(Summary, TruthsLengthsAndNoisesAreKeptApart) {
  auto lines = drives({0.1, 0.2, 0.3, 0.4});
  lines[1].key.truth = "surveyed";
  lines[2].key.km = 4;
  lines[3].key.noise = 2;
  const auto summaries = summarise(lines, GroupBy::scene);
  ASSERT_THAT(summaries, SizeIs(4));
  EXPECT_EQ(summaries[3].name, "nominal, noise x 2");
  EXPECT_EQ(summaries[3].noise, 2);
  EXPECT_FALSE(summaries[3].nominal) << "the paper's sensors had the noise of theirs";
}

TEST(Summary, RefusesToMixOrigins) {
  const auto mixed = [](const Provenance& other) {
    return summarise(std::vector{result_line(seed(1), 0.1), result_line(seed(2), 0.1, other)},
                     GroupBy::scene);
  };
  EXPECT_THROW(mixed({"1", "other", "s", "c"}), Error);
  EXPECT_THROW(mixed({"1", "p", "s", "other"}), Error);
  EXPECT_THROW(mixed({"1", "p", "other", "c"}), Error);
  EXPECT_THROW(mixed({"2", "p", "s", "c"}), Error);
}

}  // namespace
}  // namespace lanefuse
