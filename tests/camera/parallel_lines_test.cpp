// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/parallel_lines.hpp"

#include <gtest/gtest.h>

#include "core/clothoid.hpp"
#include "core/random.hpp"

namespace lanefuse {
namespace {

constexpr double kOffsets[] = {-5.4, -1.8, 1.8, 5.4};

/// Pieces of lines beside `course`, each 5 m, seen with a wrong pitch: stretched by `stretch` a metre.
std::vector<LinePiece> pieces_of(const Clothoid& course, double stretch, Random& random) {
  std::vector<LinePiece> pieces;
  for (const double offset : kOffsets) {
    for (double x = 8; x < 110; x += 6) {
      const double f = 1 + stretch * x;
      const double y = offset + course.y(x);
      const double noise = 0.005 * (1 + x / 20);
      pieces.push_back({x, f * y + random.normal(noise),
                        f * course.slope(x) + stretch * y + random.normal(0.003), noise, 0.003, 5});
    }
  }
  return pieces;
}

TEST(ParallelLines, FindsCourseOffsetsAndPitch) {
  Random random(1, "roads");
  for (int i = 0; i < 50; ++i) {
    const Clothoid course{0, random.uniform(-0.02, 0.02), random.uniform(-5e-4, 5e-4),
                          random.uniform(-2e-6, 2e-6)};
    const double stretch = random.uniform(-0.002, 0.002);
    ParallelLines lines({});
    lines.fit(pieces_of(course, stretch, random), 0.002);
    EXPECT_NEAR(lines.stretch(), stretch, 3e-4);
    for (const double offset : kOffsets) {
      const auto* line = lines.nearest(offset, 0.5);
      ASSERT_TRUE(line) << offset;
      EXPECT_NEAR(line->offset, offset, 0.15);
      EXPECT_GT(line->length, 50);
    }
    EXPECT_NEAR(lines.slope(60, course.y(60)), (1 + stretch * 60) * course.slope(60) + stretch * course.y(60),
                0.006);
  }
}

TEST(ParallelLines, IsNotDrawnByWhatPointsAtTheCamera) {
  Random random(2, "roads");
  const Clothoid course{0, 0.005, 2e-4, 0};
  std::vector<LinePiece> pieces = pieces_of(course, 0, random);
  for (int i = 0; i < 60; ++i) {  // posts and the sides of vehicles to the right
    const double x = random.uniform(15, 100);
    const double y = -random.uniform(3, 12);
    pieces.push_back({x, y, y / x + random.normal(0.02), 0.02, 0.01, random.uniform(2, 10)});
  }
  ParallelLines lines({});
  lines.fit(pieces, 0.002);
  for (const double x : {20.0, 50.0, 90.0})
    EXPECT_NEAR(lines.slope(x, course.y(x)), course.slope(x), 0.006) << x;
}

TEST(ParallelLines, OfNothingAreNone) {
  ParallelLines lines({});
  lines.fit({}, 0.002);
  EXPECT_TRUE(lines.lines().empty());
  EXPECT_EQ(lines.nearest(0, 10), nullptr);
  EXPECT_EQ(lines.slope(50, 3), 0);
}

}  // namespace
}  // namespace lanefuse
