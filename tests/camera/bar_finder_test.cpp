// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/bar_finder.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

constexpr int kWidth = 400;

/// One row of grey pixels.
struct Row {
  Image image{kWidth, 3, 1};
  PlannedRow plan{1, 0, 0, kWidth, 0, kWidth, 30, 60};  // 60 px/m: paint of .15 m is 9 px wide

  explicit Row(double level) { add(-1, kWidth, level); }
  /// Brightens from column `left` to `right`, with the share of the pixels that are cut.
  void add(double left, double right, double level) {
    for (int v = 0; v < 3; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const double share = std::min(right, u + 0.5) - std::max(left, u - 0.5);
        if (share > 0)
          at(u, v) = static_cast<std::uint8_t>(at(u, v) + std::lround(std::min(share, 1.0) * level));
      }
    }
  }
  std::uint8_t& at(int u, int v) { return image.row(v)[u]; }
};

std::vector<RowBar> bars(const Row& row) {
  RowSignal signal(kWidth);
  signal.read(row.image.view(), row.plan);
  BarFinder finder(kWidth, {});
  return finder.find(signal, row.plan, 0);
}

TEST(BarFinder, FindsTheCentreOfPaintOfAnyWidth) {
  Random random(3, "bars");
  for (int i = 0; i < 200; ++i) {
    const double left = random.uniform(100, 250);
    const double width = random.uniform(6, 18);  // .10 to .30 m
    Row row(80);
    row.add(left, left + width, 80);
    const auto found = bars(row);
    ASSERT_EQ(found.size(), 1U) << width;
    EXPECT_NEAR(found[0].centre, left + width / 2, 0.05);
    EXPECT_NEAR(found[0].right - found[0].left, width, 0.6);
    EXPECT_NEAR(found[0].contrast, 80, 8);
  }
}

TEST(BarFinder, KnowsHowFarNoiseMovesTheCentre) {
  Random random(4, "noise");
  double squares = 0;
  constexpr int kTrials = 300;
  for (int i = 0; i < kTrials; ++i) {
    const double left = random.uniform(100, 250);
    const double width = i % 2 == 0 ? 9 : 18;
    Row row(80);
    row.add(left, left + width, 50);
    for (int u = 0; u < kWidth; ++u) {
      row.at(u, 1) = static_cast<std::uint8_t>(std::lround(row.at(u, 1) + random.normal(4)));
    }
    double best = 1e9;
    double sigma = 1;
    for (const RowBar& bar : bars(row)) {
      const double error = bar.centre - left - width / 2;
      if (std::abs(error) < std::abs(best)) {
        best = error;
        sigma = bar.sigma;
      }
    }
    ASSERT_LT(std::abs(best), 2);
    squares += best * best / (sigma * sigma) / kTrials;
  }
  EXPECT_GT(squares, 0.4);
  EXPECT_LT(squares, 1.6);
}

TEST(BarFinder, WantsContrastOnBothSides) {
  Row step(80);
  step.add(200, kWidth, 60);
  EXPECT_TRUE(bars(step).empty());
  Row dark(120);
  dark.add(200, 209, -60);
  EXPECT_TRUE(bars(dark).empty());
  Row uneven(80);
  uneven.add(200, 209, 60);
  uneven.add(209, kWidth, 50);
  EXPECT_TRUE(bars(uneven).empty());
}

TEST(BarFinder, KeepsToTheWidthsOfPaint) {
  Row wide(80);
  wide.add(200, 200 + 0.5 * 60, 60);  // half a metre
  EXPECT_TRUE(bars(wide).empty());
}

TEST(BarFinder, TellsTwoLinesApart) {
  Row row(80);
  row.add(120, 129, 60);
  row.add(250, 259, 30);
  const auto found = bars(row);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].centre, 124.5, 0.1);
  EXPECT_NEAR(found[1].centre, 254.5, 0.1);
}

TEST(RowSignal, YellowStandsOutOfConcrete) {
  Image image(kWidth, 3, 3);
  for (int v = 0; v < 3; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool paint = u >= 200 && u < 209;
      std::uint8_t* pixel = image.row(v) + 3 * u;
      pixel[0] = paint ? 40 : 165;
      pixel[1] = paint ? 170 : 170;
      pixel[2] = paint ? 215 : 175;
    }
  }
  Row row(0);
  row.image = image;
  const auto found = bars(row);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].centre, 204, 0.05);
}

}  // namespace
}  // namespace lanefuse
