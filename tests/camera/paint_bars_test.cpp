// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/paint_bars.hpp"

#include <array>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

using Colour = std::array<double, 3>;  // blue, green, red

/// One row of road with bars painted area-true.
class Row {
 public:
  explicit Row(const Colour& road) : image_(200, 1, 3) { bar(-1, 201, road, 1); }

  Row& bar(double begin, double end, const Colour& colour, double strength = 1) {
    for (int u = 0; u < image_.width(); ++u) {
      const double covered =
          std::clamp(std::min(end, u + 0.5) - std::max(begin, u - 0.5), 0.0, 1.0) * strength;
      for (int c = 0; c < 3; ++c) {
        std::uint8_t& value = image_.row(0)[3 * u + c];
        value = static_cast<std::uint8_t>(
            std::lround(value + covered * (colour[static_cast<std::size_t>(c)] - value)));
      }
    }
    return *this;
  }
  [[nodiscard]] ImageView view() const { return image_.view(); }

 private:
  Image image_;
};

constexpr Colour kAsphalt = {80, 80, 80};
constexpr Colour kConcrete = {185, 195, 200};
constexpr Colour kWhite = {230, 230, 230};
constexpr Colour kYellow = {60, 195, 225};

BarQuery query(double narrowest, double widest) { return {0, 10, 190, narrowest, widest, 8}; }

TEST(PaintBars, FindsEdgesToAFractionOfAPixel) {
  Random random(3, "bars");
  PaintBarFinder finder;
  for (int i = 0; i < 200; ++i) {
    const double left = random.uniform(40, 100);
    const double width = random.uniform(4, 30);
    const Row row = Row(kAsphalt).bar(left, left + width, kWhite);
    const auto bars = finder.find(row.view(), query(2, 40));
    ASSERT_EQ(bars.size(), 1U) << left << " " << width;
    EXPECT_NEAR(bars[0].left, left, 0.15);
    EXPECT_NEAR(bars[0].right, left + width, 0.15);
    EXPECT_FALSE(bars[0].yellow);
  }
}

TEST(PaintBars, TakesOnlyBarsOfTheRightWidth) {
  PaintBarFinder finder;
  const Row row = Row(kAsphalt).bar(30, 33, kWhite).bar(60, 72, kWhite).bar(100, 160, kWhite);
  const auto bars = finder.find(row.view(), query(8, 20));
  ASSERT_EQ(bars.size(), 1U);
  EXPECT_NEAR(bars[0].left, 60, 0.2);
}

TEST(PaintBars, SeesYellowOnConcreteThatIsAsBright) {
  PaintBarFinder finder;
  const Row row = Row(kConcrete).bar(60, 72, {70, 195, 220});
  const auto bars = finder.find(row.view(), query(6, 20));
  ASSERT_EQ(bars.size(), 1U);
  EXPECT_TRUE(bars[0].yellow);
  EXPECT_NEAR(bars[0].left, 60, 0.4);
  EXPECT_NEAR(bars[0].right, 72, 0.4);
}

TEST(PaintBars, TellsYellowFromWhite) {
  PaintBarFinder finder;
  const Row row = Row(kAsphalt).bar(60, 70, kYellow).bar(120, 130, kWhite);
  const auto bars = finder.find(row.view(), query(6, 20));
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_TRUE(bars[0].yellow);
  EXPECT_FALSE(bars[1].yellow);
}

TEST(PaintBars, AnEdgeOfShadowIsNoBar) {
  PaintBarFinder finder;
  const Row row = Row(kAsphalt).bar(100, 201, {30, 30, 30});
  EXPECT_TRUE(finder.find(row.view(), query(2, 40)).empty());
}

TEST(PaintBars, StaysInsideTheImage) {
  PaintBarFinder finder;
  const Row row = Row(kAsphalt).bar(-1, 6, kWhite).bar(195, 201, kWhite);
  BarQuery outside = query(2, 40);
  outside.left = -50;
  outside.right = 400;
  finder.find(row.view(), outside);
  outside.row = 5;
  EXPECT_TRUE(finder.find(row.view(), outside).empty());
}

}  // namespace
}  // namespace lanefuse
