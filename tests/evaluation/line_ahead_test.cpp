// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/line_ahead.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lanefuse {
namespace {

LineAhead line(const std::vector<Eigen::Vector2d>& points) {
  LineAhead result;
  for (const auto& point : points) result.extend(point);
  return result;
}

TEST(LineAhead, KnowsItsEnds) {
  const LineAhead sloped = line({{-10, -1}, {10, 1}, {20, 4}});
  EXPECT_DOUBLE_EQ(*sloped.y(0), 0);
  EXPECT_DOUBLE_EQ(*sloped.y(15), 2.5);
  EXPECT_DOUBLE_EQ(*sloped.y(20), 4);
  EXPECT_FALSE(sloped.y(-10.1));
  EXPECT_FALSE(sloped.y(20.1));
  EXPECT_FALSE(line({{0, 0}}).y(0));
  EXPECT_FALSE(line({}).y(0));
}

TEST(LineAhead, OnlyGoesForward) {
  const LineAhead jittering = line({{0, 0}, {0, 1}, {-1, 2}, {0.01, 3}, {5, 0}});
  EXPECT_EQ(jittering.points().size(), 2U);
}

TEST(LineAhead, MeasuresAcrossAndNotAlongY) {
  const LineAhead diagonal = line({{0, 0}, {100, 100}});
  EXPECT_NEAR(diagonal.deviation({50, 51}), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(diagonal.deviation({50, 49}), -std::sqrt(0.5), 1e-12);
}

TEST(LineAhead, TakesTheCornerOutsideOfABend) {
  const LineAhead bend = line({{0, 0}, {10, 0}, {20, -10}});
  EXPECT_NEAR(bend.deviation({10.1, 1}), std::hypot(0.1, 1), 1e-12);
}

TEST(LineAhead, ProlongsItsEnds) {
  const LineAhead short_line = line({{0, 0}, {10, 10}});
  EXPECT_NEAR(short_line.deviation({10, 12}), std::sqrt(2), 1e-12);
  EXPECT_NEAR(short_line.deviation({0, -2}), -std::sqrt(2), 1e-12);
}

RC_GTEST_PROP(LineAhead, IsTheDistanceFromACircle, ()) {
  const double radius = *rc::gen::inRange(300, 3000);
  const double x = *rc::gen::inRange(0, 121);
  const double offset = *rc::gen::inRange(-40, 41) * 0.1;
  LineAhead arc;
  for (double along = -30; along < 160; along += 0.5) {
    arc.extend({radius * std::sin(along / radius), radius * (1 - std::cos(along / radius))});
  }
  const Eigen::Vector2d point(x, *arc.y(x) + offset);
  // The circle bends left: what is nearer to its centre lies left of the line.
  RC_ASSERT(std::abs(arc.deviation(point) - (radius - (point - Eigen::Vector2d(0, radius)).norm())) < 3e-4);
}

}  // namespace
}  // namespace lanefuse
