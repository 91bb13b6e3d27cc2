// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/lane_description.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/boundary_curve.hpp"
#include "core/lane_availability.hpp"

namespace lanefuse {
namespace {

/// A boundary on a circle around (0, radius), `inwards` of it, with points that a cubic cannot follow.
Boundary on_circle(std::uint64_t id, double radius, double inwards) {
  Boundary boundary;
  boundary.id = id;
  boundary.clothoid = {inwards, 0, 1 / radius, 0};
  boundary.range_end = 100;
  boundary.confidence = 0.1 * static_cast<double>(id);
  for (double x = 0; x <= 100; x += kPointSpacing) {
    const double y = radius - std::sqrt((radius - inwards) * (radius - inwards) - x * x);
    boundary.points.push_back({x, y, 0.1 * static_cast<double>(id), 0});
  }
  return boundary;
}

Lane lane_between(std::uint64_t id, std::uint64_t left, std::uint64_t right) {
  Lane lane;
  lane.id = id;
  lane.left_boundary = left;
  lane.right_boundary = right;
  return lane;
}

LaneEstimate bend(double radius) {
  LaneEstimate estimate;
  estimate.boundaries = {on_circle(3, radius, 1.8), on_circle(4, radius, -1.8)};
  estimate.lanes = {lane_between(7, 3, 4)};
  describe_lanes(estimate);
  return estimate;
}

TEST(LaneDescription, FollowsTheMiddleOfASharpBend) {
  constexpr double kRadius = 250;
  const LaneEstimate estimate = bend(kRadius);
  const Lane& lane = estimate.lanes.front();
  ASSERT_EQ(lane.centre.size(), 11U);
  for (const LanePoint& point : lane.centre) {
    const double heading = std::asin(point.x / kRadius);
    EXPECT_NEAR(point.y, kRadius - std::sqrt(kRadius * kRadius - point.x * point.x), 0.01) << point.x;
    EXPECT_NEAR(point.heading, heading, 0.005) << point.x;
    EXPECT_NEAR(point.curvature, 1 / kRadius, 2e-4) << point.x;
    EXPECT_NEAR(point.width, 3.6, 0.02) << point.x;
  }
}

TEST(LaneDescription, IsWhereBothBoundariesSpeak) {
  LaneEstimate estimate;
  estimate.boundaries = {on_circle(3, 800, 1.8), on_circle(4, 800, -1.8)};
  estimate.boundaries[0].range_begin = 8;
  estimate.boundaries[1].range_end = 51;
  estimate.lanes = {lane_between(7, 3, 4)};
  describe_lanes(estimate);
  const Lane& lane = estimate.lanes.front();
  EXPECT_EQ(lane.range_begin, 8);
  EXPECT_EQ(lane.range_end, 51);
  ASSERT_EQ(lane.centre.size(), 5U);
  EXPECT_EQ(lane.centre.front().x, 8);
  EXPECT_EQ(lane.centre.back().x, 48);
  EXPECT_DOUBLE_EQ(lane.confidence, 0.3);
}

TEST(LaneDescription, SigmasAreTheLargestThatTheBoundariesAllow) {
  const LaneEstimate estimate = bend(800);
  for (const LanePoint& point : estimate.lanes.front().centre) {
    EXPECT_NEAR(point.sigma, 0.35, 1e-12);
    EXPECT_NEAR(point.width_sigma, 0.5, 1e-12);
  }
}

TEST(LaneDescription, SaysNothingWithoutBothBoundaries) {
  LaneEstimate estimate = bend(800);
  estimate.boundaries.pop_back();
  describe_lanes(estimate);
  EXPECT_TRUE(estimate.lanes.front().centre.empty());
  EXPECT_EQ(estimate.lanes.front().range_end, 0);

  estimate = bend(800);
  estimate.boundaries[0].range_begin = 60;
  estimate.boundaries[1].range_end = 40;
  describe_lanes(estimate);
  EXPECT_TRUE(estimate.lanes.front().centre.empty());
  EXPECT_EQ(estimate.lanes.front().range_begin, estimate.lanes.front().range_end);
}

RC_GTEST_PROP(BoundaryCurve, IsTheClothoidWhereThePointsAre, ()) {
  Boundary boundary;
  boundary.clothoid = {1.8, *rc::gen::inRange(-50, 51) * 1e-3, *rc::gen::inRange(-50, 51) * 1e-5, 1e-6};
  boundary.range_end = *rc::gen::inRange(0, 120);
  sample_points(boundary);
  const double x = *rc::gen::inRange(-100, 1400) * 0.1;
  RC_ASSERT(curve_at(boundary, x) == boundary.clothoid.y(x));
  RC_ASSERT(std::abs(shape_at(boundary, x).slope - boundary.clothoid.slope(x)) < 1e-12);
  RC_ASSERT(std::abs(shape_at(boundary, x).bend - boundary.clothoid.curvature_at(x)) < 1e-12);
}

TEST(BoundaryCurve, GoesThroughPointsAndOnWithoutAStep) {
  const Boundary boundary = on_circle(3, 300, 1.8);
  for (const BoundaryPoint& point : boundary.points) EXPECT_NEAR(curve_at(boundary, point.x), point.y, 1e-12);
  EXPECT_NEAR(curve_at(boundary, 100.001), curve_at(boundary, 100), 1e-3);
  EXPECT_NEAR(curve_at(boundary, -0.001), curve_at(boundary, 0), 1e-3);
}

/// A cycle in which these lanes reach so far.
LaneEstimate cycle(double seconds, const std::vector<std::pair<std::uint64_t, double>>& lanes) {
  LaneEstimate estimate;
  estimate.time = from_nanoseconds(0) + from_seconds(seconds);
  for (const auto& [id, range_end] : lanes) {
    estimate.lanes.push_back(lane_between(id, 0, 0));
    estimate.lanes.back().range_end = range_end;
  }
  return estimate;
}

TEST(LaneAvailability, IsTheShareOfTheCyclesInWhichTheLaneReachedSixtyMetres) {
  LaneAvailability availability;
  LaneEstimate estimate;
  for (int i = 0; i < 4; ++i) {
    estimate = cycle(i, {{1, 80}, {2, i < 2 ? 59.9 : 60}});
    availability.update(estimate);
  }
  EXPECT_DOUBLE_EQ(estimate.lanes[0].availability, 1);
  EXPECT_DOUBLE_EQ(estimate.lanes[1].availability, 0.5);
  estimate = cycle(4, {{3, 100}, {2, 10}});
  availability.update(estimate);
  EXPECT_DOUBLE_EQ(estimate.lanes[0].availability, 0.2) << "it was born now";
  EXPECT_DOUBLE_EQ(estimate.lanes[1].availability, 0.4);
}

TEST(LaneAvailability, ForgetsWhatIsTenSecondsOld) {
  LaneAvailability availability;
  LaneEstimate estimate;
  for (int i = 0; i < 400; ++i) {
    estimate = cycle(0.1 * i, {{1, i < 250 ? 80 : 40}});
    availability.update(estimate);
    if (i == 299) {
      EXPECT_NEAR(estimate.lanes[0].availability, 0.5, 1e-9);
    }
  }
  EXPECT_EQ(estimate.lanes[0].availability, 0);
}

TEST(LaneAvailability, BeginsAnewAfterAReset) {
  LaneAvailability availability;
  LaneEstimate estimate = cycle(0, {{1, 40}});
  availability.update(estimate);
  availability.reset();
  estimate = cycle(1, {{1, 80}});
  availability.update(estimate);
  EXPECT_DOUBLE_EQ(estimate.lanes[0].availability, 1);
}

}  // namespace
}  // namespace lanefuse
