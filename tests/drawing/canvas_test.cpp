// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/canvas.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

constexpr Colour kBlack{0, 0, 0};
constexpr Colour kInk{200, 100, 50};

Colour at(const Canvas& canvas, int u, int v) {
  const std::uint8_t* pixel = canvas.image().view().row(v) + std::ptrdiff_t{3} * u;
  return {pixel[2], pixel[1], pixel[0]};
}

int painted(const Canvas& canvas) {
  int count = 0;
  for (int v = 0; v < canvas.image().height(); ++v) {
    for (int u = 0; u < canvas.image().width(); ++u) count += at(canvas, u, v) == kBlack ? 0 : 1;
  }
  return count;
}

TEST(Canvas, PaintsWhereItIsToldTo) {
  Canvas canvas(60, 40, kBlack);
  canvas.line({10, 20}, {50, 20}, {kInk, 3});
  EXPECT_EQ(at(canvas, 30, 20), kInk);
  EXPECT_EQ(at(canvas, 30, 25), kBlack);
  EXPECT_EQ(at(canvas, 56, 20), kBlack);
  canvas.fill(Box{2, 2, 6, 6}, {255, 255, 255});
  EXPECT_EQ(at(canvas, 5, 5), (Colour{255, 255, 255}));
  canvas.disc({50, 8}, 4, kInk);
  EXPECT_EQ(at(canvas, 50, 8), kInk);
}

TEST(Canvas, DashesLeaveGapsAsLongAsThemselves) {
  Canvas canvas(200, 10, kBlack);
  canvas.line({0, 5}, {200, 5}, {kInk, 3, 20});
  EXPECT_EQ(at(canvas, 10, 5), kInk);
  EXPECT_EQ(at(canvas, 30, 5), kBlack);
  EXPECT_EQ(at(canvas, 50, 5), kInk);
  // Also where the line comes in many short pieces.
  Canvas pieces(200, 10, kBlack);
  std::vector<Pixel> points;
  for (double u = 0; u <= 200; u += 3) points.emplace_back(u, 5);
  pieces.polyline(points, {kInk, 3, 20});
  EXPECT_EQ(at(pieces, 10, 5), kInk);
  EXPECT_EQ(at(pieces, 30, 5), kBlack);
  EXPECT_EQ(at(pieces, 50, 5), kInk);
}

TEST(Canvas, ClippingKeepsTheRest) {
  Canvas canvas(60, 40, kBlack);
  canvas.begin_clip({20, 10, 10, 10});
  canvas.fill(Box{0, 0, 60, 40}, kInk);
  canvas.line({0, 15}, {60, 15}, {kInk, 5});
  canvas.end_clip();
  EXPECT_EQ(painted(canvas), 100);
  EXPECT_EQ(at(canvas, 20, 10), kInk);
  EXPECT_EQ(at(canvas, 30, 10), kBlack);
  canvas.fill(Box{40, 30, 5, 5}, kInk);
  EXPECT_EQ(at(canvas, 42, 32), kInk);
}

TEST(Canvas, WhatIsHalfTransparentLetsTheRestShow) {
  Canvas canvas(30, 30, {100, 100, 100});
  canvas.fill(std::array{Pixel(5, 5), Pixel(25, 5), Pixel(25, 25), Pixel(5, 25)}, {200, 200, 200}, 0.5);
  EXPECT_EQ(at(canvas, 15, 15), (Colour{150, 150, 150}));
  EXPECT_EQ(at(canvas, 2, 15), (Colour{100, 100, 100}));
}

TEST(Canvas, APlaceThatIsNoneBreaksTheLine) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Canvas canvas(100, 20, kBlack);
  canvas.polyline(std::array{Pixel(5, 10), Pixel(30, 10), Pixel(kNone, 10), Pixel(70, 10), Pixel(95, 10)},
                  {kInk, 3});
  EXPECT_EQ(at(canvas, 20, 10), kInk);
  EXPECT_EQ(at(canvas, 50, 10), kBlack);
  EXPECT_EQ(at(canvas, 80, 10), kInk);
  Canvas empty(100, 20, kBlack);
  empty.disc({kNone, 5}, 3, kInk);
  empty.text({1e300, 5}, "words", kInk, 9);
  empty.fill(std::array{Pixel(5, 10), Pixel(kNone, 10), Pixel(9, 12)}, kInk);
  EXPECT_EQ(painted(empty), 0);
}

TEST(Canvas, PlacesAnImageScaled) {
  Image image(4, 2, 3);
  for (int u = 0; u < 4; ++u) image.row(1)[3 * u + 2] = 255;
  Canvas canvas(60, 40, kBlack);
  canvas.place(image.view(), {10, 10, 40, 20});
  EXPECT_EQ(at(canvas, 30, 28), (Colour{255, 0, 0}));
  EXPECT_EQ(at(canvas, 30, 11), kBlack);
  EXPECT_EQ(at(canvas, 5, 28), kBlack);
  canvas.place({}, {0, 0, 60, 40});  // no image, nothing to place
  EXPECT_EQ(at(canvas, 30, 28), (Colour{255, 0, 0}));
}

}  // namespace
}  // namespace lanefuse
