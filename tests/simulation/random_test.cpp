// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/random.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::Moments;

TEST(Random, GivesTheSameNumbersForEver) {
  Random random(1, "road");
  EXPECT_EQ(random.bits(), 12856767543276384268ULL);
  EXPECT_EQ(random.bits(), 13715226134602280866ULL);
}

TEST(Random, StreamsOfOneSeedDiffer) {
  EXPECT_NE(Random(1, "road").bits(), Random(1, "traffic").bits());
  EXPECT_NE(Random(1, "road").bits(), Random(2, "road").bits());
}

TEST(Random, DrawsFromItsDistributions) {
  Random random(7, "test");
  Moments uniform, normal, exponential;
  for (int i = 0; i < 200'000; ++i) {
    uniform.add(random.uniform(2, 4));
    normal.add(random.normal(3));
    exponential.add(random.exponential(5));
  }
  EXPECT_NEAR(uniform.mean(), 3, 0.01);
  EXPECT_NEAR(uniform.sigma(), 2 / std::sqrt(12), 0.01);
  EXPECT_NEAR(normal.mean(), 0, 0.03);
  EXPECT_NEAR(normal.sigma(), 3, 0.03);
  EXPECT_NEAR(exponential.mean(), 5, 0.05);
  EXPECT_NEAR(exponential.sigma(), 5, 0.08);
}

TEST(Wander, KeepsItsSigmaAndForgetsWithItsTimeConstant) {
  Random random(7, "wander");
  Wander wander(0.3, 0.5, random);
  Moments values;
  double product = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double before = wander.value();
    wander.advance(0.1, random);
    values.add(wander.value());
    product += before * wander.value();
  }
  EXPECT_NEAR(values.sigma(), 0.3, 0.01);
  EXPECT_NEAR(product / values.count() / (0.3 * 0.3), std::exp(-0.1 / 0.5), 0.02);
}

TEST(Random, CountsAsPoissonAndDrawsWholeNumbersEvenly) {
  Random random(1, "counts");
  double sum = 0, squares = 0;
  std::array<int, 3> drawn{};
  for (int i = 0; i < 20'000; ++i) {
    const double count = random.poisson(2);
    sum += count;
    squares += count * count;
    drawn.at(static_cast<std::size_t>(random.whole(1, 3) - 1)) += 1;
  }
  const double mean = sum / 20'000;
  EXPECT_NEAR(mean, 2, 0.05);
  EXPECT_NEAR(squares / 20'000 - mean * mean, 2, 0.1);
  for (const int times : drawn) EXPECT_NEAR(times, 20'000 / 3.0, 300);
  EXPECT_EQ(random.poisson(0), 0);
}

}  // namespace
}  // namespace lanefuse
