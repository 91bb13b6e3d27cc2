// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/synthetic_results.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

using testing::drives;
using testing::result_line;
using testing::seed;

const FigureChange& change_of(const Comparison& comparison, const std::string& name) {
  for (const FigureChange& change : comparison.figures) {
    if (change.figure->name == name) return change;
  }
  throw std::runtime_error("no figure " + name);
}

std::vector<ResultLine> as_variant(std::vector<ResultLine> lines, const std::string& variant) {
  for (ResultLine& line : lines) line.key.variant = variant;
  return lines;
}

// Seeds differ among each other far more than from A to B: only pairs can show what changed.
const std::vector<double> kBefore{0.10, 0.30, 0.20, 0.50, 0.40, 0.60};
const std::vector<double> kAfter{0.111, 0.309, 0.210, 0.511, 0.410, 0.609};

TEST(Compare, PairsShowWhatSeedsWouldHide) {
  const Comparison comparison = compare(drives(kBefore), drives(kAfter));
  EXPECT_EQ(comparison.pairs, 6U);
  const FigureChange& change = change_of(comparison, "ego RMSE at 0 m");
  EXPECT_NEAR(change.change.mean, 0.01, 1e-9);
  EXPECT_NEAR(change.in_a, 0.35, 1e-9);
  EXPECT_EQ(change.drives, 6U);
  EXPECT_EQ(change.verdict, Verdict::worse);
  EXPECT_EQ(change_of(comparison, "wrong-lane rate").verdict, Verdict::noise);
  EXPECT_EQ(change_of(compare(drives(kAfter), drives(kBefore)), "ego RMSE at 0 m").verdict, Verdict::better);
}

TEST(Compare, LessAvailabilityIsWorse) {
  auto less = drives(kBefore);
  double by = 0.1;
  for (ResultLine& line : less) line.json["lanes"]["ego"][6]["availability"] = 1 - (by += 0.001);
  EXPECT_EQ(change_of(compare(drives(kBefore), less), "ego reaches 60 m").verdict, Verdict::worse);
}

TEST(Compare, TheSameIsNoise) {
  for (const FigureChange& change : compare(drives(kBefore), drives(kBefore)).figures) {
    EXPECT_EQ(change.verdict, Verdict::noise) << change.figure->name;
  }
}

TEST(Compare, CorrectsForTheNumberOfFigures) {
  // One figure of many at p = 0.02: nothing where one looks at fourteen.
  auto after = drives(kBefore);
  const double steps[] = {0.001, 0.012, 0.004, 0.014, 0.002, 0.009};
  for (std::size_t i = 0; i < after.size(); ++i) {
    auto& rmse = after[i].json["lanes"]["ego"][0]["rmse_m"];
    rmse = rmse.get<double>() + steps[i];
  }
  const Comparison comparison = compare(drives(kBefore), after);
  const FigureChange& change = change_of(comparison, "ego RMSE at 0 m");
  EXPECT_LT(change.change.probability.value(), 0.05);
  EXPECT_DOUBLE_EQ(change.chance.value(),
                   static_cast<double>(comparison.figures.size()) * *change.change.probability);
  EXPECT_EQ(change.verdict, Verdict::noise);
}

TEST(Compare, OnePairDecidesNothing) {
  const Comparison comparison = compare(drives({0.1}), drives({0.2}));
  EXPECT_EQ(change_of(comparison, "ego RMSE at 0 m").verdict, Verdict::unknown);
}

TEST(Compare, CountsWhatHasNoPartner) {
  const Comparison comparison = compare(drives(kBefore), drives({0.1, 0.3}));
  EXPECT_EQ(comparison.pairs, 2U);
  EXPECT_EQ(comparison.only_in_a, 4U);
  EXPECT_EQ(comparison.only_in_b, 0U);
}

TEST(Compare, TwoVariantsArePairedByDrive) {
  EXPECT_EQ(compare(drives(kBefore), as_variant(drives(kAfter), "no-width")).pairs, 6U);
}

TEST(Compare, SidesOfManyVariantsArePairedByName) {
  auto a = drives(kBefore);
  const auto more = as_variant(drives(kAfter), "no-width");
  a.insert(a.end(), more.begin(), more.end());
  EXPECT_EQ(compare(a, a).pairs, 12U);
  EXPECT_EQ(compare(a, more).pairs, 6U);
}

TEST(Compare, TwoEstimatorsArePairedOverWhatTheyAreCalled) {
  const auto by = [](std::vector<ResultLine> lines, const std::string& estimator) {
    for (ResultLine& line : lines) line.key.estimator = estimator;
    return lines;
  };
  std::vector<ResultLine> graph = by(drives(kBefore), "graph");
  std::vector<ResultLine> road = by(drives(kAfter), "road");
  EXPECT_EQ(compare(graph, road).pairs, 6U);
  // Variants are told apart by name all the same.
  for (auto* side : {&graph, &road}) {
    const auto more = as_variant(*side, "no-width");
    side->insert(side->end(), more.begin(), more.end());
  }
  EXPECT_EQ(compare(graph, road).pairs, 12U);
  // And estimators are, where a side holds several.
  std::vector<ResultLine> both = graph;
  both.insert(both.end(), road.begin(), road.end());
  const Comparison comparison = compare(both, road);
  EXPECT_EQ(comparison.pairs, 12U);
  EXPECT_EQ(comparison.only_in_a, 12U);
  EXPECT_EQ(change_of(comparison, "ego RMSE at 0 m").change.mean, 0);
}

TEST(Compare, OtherSeedsAreComparedAsAWhole) {
  auto others = drives({0.31, 0.33, 0.32});
  for (ResultLine& line : others) line.key.seed += 100;
  const Comparison comparison = compare(drives({0.11, 0.12, 0.10}), others);
  EXPECT_EQ(comparison.pairs, 0U);
  EXPECT_EQ(comparison.only_in_b, 3U);
  EXPECT_EQ(change_of(comparison, "ego RMSE at 0 m").verdict, Verdict::worse);
}

TEST(Compare, RefusesWhatCannotBeCompared) {
  const std::vector other_preset{result_line(seed(1), 0.1, {"1", "other", "s", "c"})};
  EXPECT_THROW(compare(drives({0.1}), other_preset), Error);
  const std::vector other_scene{result_line(seed(1), 0.1, {"1", "p", "other", "c"})};
  EXPECT_THROW(compare(drives({0.1}), other_scene), Error);
  auto other_truth = drives({0.1});
  other_truth[0].key.truth = "surveyed";
  EXPECT_THROW(compare(drives({0.1}), other_truth), Error);
  EXPECT_THROW(compare({}, drives({0.1})), Error);
}

}  // namespace
}  // namespace lanefuse
