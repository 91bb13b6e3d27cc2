// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/coverage.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/synthetic_results.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "evaluation/consistency.hpp"
#include "evaluation/evaluation_json.hpp"

namespace lanefuse {
namespace {

using testing::result_line;
using testing::seed;
using ::testing::SizeIs;

/// How a synthetic estimator's errors relate to what it says.
struct Errors {
  double a_drive = 0;  ///< [m] sigma of the error that a whole drive shares
  double white = 0;    ///< [m] sigma of each deviation's own
  double stated = 0.1;
  double protection = 0;
};

/// A drive's line, whose deviations are drawn, at every distance alike.
ResultLine drawn(std::uint64_t number, const Errors& errors) {
  Random random(number, "coverage");
  const double shared = random.normal(errors.a_drive);
  EvaluationResult result;
  ConsistencyByDistance consistency;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    for (int cycle = 0; cycle < 100; ++cycle) {
      const double deviation = shared + random.normal(errors.white);
      consistency.add(i, deviation, errors.stated);
      consistency.add_protection(i, deviation, errors.protection);
    }
  }
  result.consistency = {consistency.statistics(), consistency.statistics()};
  ResultLine line = result_line(seed(number), 0.1);
  line.json["consistency"] = to_json(result)["consistency"];
  return line;
}

Coverage judged(const Errors& errors, std::uint64_t drives = 400) {
  std::vector<ResultLine> lines;
  for (std::uint64_t i = 1; i <= drives; ++i) lines.push_back(drawn(i, errors));
  return coverage_of(lines, GroupBy::drive_kind).front();
}

TEST(Coverage, HonestIntervalsAreFoundHonest) {
  const Coverage coverage = judged({.a_drive = 0.06, .white = 0.08});  // 0.1 in all, as stated
  EXPECT_EQ(coverage.drives, 400U);
  ASSERT_THAT(coverage.ego, SizeIs(kDistanceCount));
  EXPECT_DOUBLE_EQ(coverage.ego[6].distance_m, 60);
  for (const CoverageAt& at : coverage.ego) {
    EXPECT_EQ(at.verdict, CoverageVerdict::honest);
    EXPECT_NEAR(at.within[1]->value, 0.95, 0.02);
    EXPECT_NEAR(at.nees->value, 1, 0.1);
    EXPECT_NEAR(at.stated_sigma->value, 0.1, 1e-12);
    EXPECT_FALSE(at.protection) << "vouched for none";
    EXPECT_FALSE(at.misleading_rate);
  }
  EXPECT_EQ(honest_count(coverage).honest, 26U);
  EXPECT_EQ(honest_count(coverage).of, 26U);
}

TEST(Coverage, MistunedIntervalsAreNamed) {
  const CoverageAt narrow = judged({.white = 0.2}).ego[0];
  EXPECT_EQ(narrow.verdict, CoverageVerdict::too_narrow);
  EXPECT_TRUE(narrow.certain);
  const CoverageAt wide = judged({.white = 0.05}).adjacent[12];
  EXPECT_EQ(wide.verdict, CoverageVerdict::too_wide);
  EXPECT_TRUE(wide.certain);
}

TEST(Coverage, FewDrivesWithSharedErrorsLeaveDoubt) {
  const CoverageAt few = judged({.a_drive = 0.1, .white = 0.01}, 5).ego[0];
  EXPECT_FALSE(few.certain);
  EXPECT_GT(*few.within[0]->high - *few.within[0]->low, 0.3);
  EXPECT_FALSE(judged({.white = 0.1}, 1).ego[0].certain) << "one drive has no interval";
}

TEST(Coverage, ErrorsThatAreNotNormalHaveWrongTails) {
  std::vector<ResultLine> lines;
  for (std::uint64_t i = 1; i <= 100; ++i) {
    lines.push_back(drawn(i, {.white = i % 10 == 0 ? 0.5 : 0.05}));
  }
  EXPECT_EQ(coverage_of(lines, GroupBy::scene)[0].ego[3].verdict, CoverageVerdict::wrong_tails);
}

TEST(Coverage, CountsWhatWasBeyondTheProtectionLevel) {
  const CoverageAt at = judged({.white = 0.1, .protection = 0.3}).ego[5];
  EXPECT_NEAR(at.misleading_rate->value, 0.0027, 0.0006);
  EXPECT_DOUBLE_EQ(at.protection->value, 0.3);
  EXPECT_EQ(at.n_protected, 40'000U);
  EXPECT_LT(*at.misleading_rate->low, at.misleading_rate->value);
}

TEST(Coverage, WhatNoDriveHasShownIsNotImpossible) {
  const CoverageAt at = judged({.white = 0.1, .protection = 2}, 100).ego[5];
  EXPECT_EQ(at.misleading_rate->value, 0);
  EXPECT_EQ(*at.misleading_rate->low, 0);
  EXPECT_NEAR(*at.misleading_rate->high, 0.0295, 1e-4);
}

TEST(Coverage, DrivesWeighByTheirDeviations) {
  std::vector<ResultLine> lines{drawn(1, {.white = 0.01}), drawn(2, {.white = 0.01})};
  lines[0].json["consistency"]["ego"][0]["within_68"] = 0.5;
  lines[0].json["consistency"]["ego"][0]["n"] = 300;
  const CoverageAt at = coverage_of(lines, GroupBy::drive_kind)[0].ego[0];
  EXPECT_NEAR(at.within[0]->value, (3 * 0.5 + 1) / 4, 1e-9);
}

TEST(Coverage, LinesFromBeforeProtectionLevelsAreRead) {
  std::vector<ResultLine> lines{drawn(1, {.white = 0.1}), drawn(2, {.white = 0.1})};
  for (ResultLine& line : lines) {
    for (const char* lane : {"ego", "adjacent"}) {
      for (auto& at : line.json["consistency"][lane]) {
        for (const char* key : {"stated_sigma_m", "protection_m", "misleading_rate", "n_protected"})
          at.erase(key);
      }
    }
  }
  const CoverageAt at = coverage_of(lines, GroupBy::drive_kind)[0].ego[0];
  EXPECT_TRUE(at.verdict);
  EXPECT_FALSE(at.stated_sigma);
  EXPECT_EQ(at.n_protected, 0U);
  lines = {result_line(seed(1), 0.1)};  // without any consistency
  EXPECT_FALSE(coverage_of(lines, GroupBy::drive_kind)[0].ego[0].verdict);
  EXPECT_EQ(honest_count(coverage_of(lines, GroupBy::drive_kind)[0]).of, 0U);
}

TEST(Coverage, NoisesAreKeptApart) {
  std::vector<ResultLine> lines{drawn(1, {.white = 0.1}), drawn(2, {.white = 0.2})};
  lines[1].key.noise = 2;
  const auto rows = coverage_of(lines, GroupBy::scene);
  ASSERT_THAT(rows, SizeIs(2));
  EXPECT_EQ(rows[0].name, "nominal");
  EXPECT_EQ(rows[1].name, "nominal, noise x 2");
  EXPECT_EQ(rows[1].noise, 2);
}

}  // namespace
}  // namespace lanefuse
