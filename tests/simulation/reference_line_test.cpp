// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/reference_line.hpp"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "simulation/preset.hpp"
#include "simulation/road_course.hpp"

namespace lanefuse {
namespace {

TEST(ReferenceLine, FollowsACircleExactly) {
  const double radius = 600;
  const ReferenceLine line({{2000, 1 / radius, 0}});
  for (double station = 0; station <= 2000; station += 7.3) {
    const Pose2 pose = line.pose(station);
    EXPECT_NEAR(pose.x, radius * std::sin(station / radius), 1e-9);
    EXPECT_NEAR(pose.y, radius * (1 - std::cos(station / radius)), 1e-9);
    EXPECT_NEAR(pose.heading, station / radius, 1e-12);
  }
}

TEST(ReferenceLine, FollowsAClothoidExactly) {
  const double rate = 1 / (200.0 * 600.0);
  const ReferenceLine line({{200, 0, rate}});
  std::complex<double> sum = 0;  // Simpson's rule on exp(i rate s^2 / 2), far finer than the line's own table
  const int steps = 20'000;
  for (int i = 0; i <= steps; ++i) {
    const double s = 200.0 * i / steps;
    const double weight = i == 0 || i == steps ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * std::polar(1.0, rate * s * s / 2);
  }
  sum *= 200.0 / steps / 3;
  EXPECT_NEAR(line.pose(200).x, sum.real(), 1e-9);
  EXPECT_NEAR(line.pose(200).y, sum.imag(), 1e-9);
}

RC_GTEST_PROP(RoadCourse, BendsWithinItsRadiiAndNeverJumps, (std::uint64_t seed)) {
  const RoadPreset preset = nominal_preset().road;
  const Range radius = seed % 2 == 0 ? preset.gentle_radius : preset.curved_radius;
  Random random(seed, "test");
  const ReferenceLine line(draw_road_course(radius, 8000, random));
  RC_ASSERT(line.length() >= 8000);
  const double steepest = 9 / (radius.low * radius.low);  // A = R/3 at the smallest radius
  for (double s = 0; s + 0.5 <= line.length(); s += 0.5) {
    RC_ASSERT(std::abs(line.curvature(s)) <= 1 / radius.low + 1e-12);
    RC_ASSERT(std::abs(line.curvature(s + 0.5) - line.curvature(s)) <= 0.5 * steepest * 1.01);
    RC_ASSERT(std::abs(line.heading(s + 0.5) - line.heading(s)) <= 0.5 / radius.low + 1e-12);
    RC_ASSERT(std::abs(line.heading(s)) < 1.57);  // so it never meets itself
    const Pose2 step = line.pose(s).inverse() * line.pose(s + 0.5);
    RC_ASSERT(std::abs(step.position().norm() - 0.5) < 1e-6);
  }
}

TEST(RoadCourse, BendsToBothSidesThroughItsWholeRange) {
  Random random(3, "test");
  const Range radius = nominal_preset().road.gentle_radius;
  double sharpest_left = 0, sharpest_right = 0;
  double arcs = 0;
  for (const RoadElement& element : draw_road_course(radius, 200'000, random)) {
    if (element.curvature_rate != 0 || element.curvature == 0) continue;
    ++arcs;
    EXPECT_GE(std::abs(1 / element.curvature), radius.low);
    EXPECT_LE(std::abs(1 / element.curvature), radius.high);
    sharpest_left = std::max(sharpest_left, element.curvature);
    sharpest_right = std::min(sharpest_right, element.curvature);
  }
  EXPECT_GT(arcs, 50);
  EXPECT_NEAR(1 / sharpest_left, radius.low, 400);
  EXPECT_NEAR(-1 / sharpest_right, radius.low, 400);
}

}  // namespace
}  // namespace lanefuse
