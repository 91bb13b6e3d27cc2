// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/lane_estimate.hpp"

#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

/// Boundaries 1, 2 ... at these offsets, from left to right, and lanes 11, 12 ... between them.
LaneEstimate road_with(const std::vector<double>& offsets) {
  LaneEstimate estimate;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    Boundary boundary;
    boundary.id = i + 1;
    boundary.clothoid.lateral_offset = offsets[i];
    estimate.boundaries.push_back(boundary);
    if (i > 0) estimate.lanes.push_back({10 + i, i, i + 1, {}, {}});
  }
  return estimate;
}

std::uint64_t ego_lane_of(const std::vector<double>& offsets) {
  const LaneEstimate estimate = road_with(offsets);
  const Lane* lane = ego_lane(estimate);
  return lane ? lane->id : 0;
}

TEST(EgoLane, IsTheOneAroundTheCar) {
  EXPECT_EQ(ego_lane_of({5.4, 1.8, -1.8, -5.4}), 12U);
  EXPECT_EQ(ego_lane_of({1.8, -1.8, -5.4}), 11U) << "in the leftmost lane";
  EXPECT_EQ(ego_lane_of({5.4, 1.8, -1.8}), 12U) << "in the rightmost lane";
}

TEST(EgoLane, BelongsToExactlyOneLaneOnABoundary) {
  EXPECT_EQ(ego_lane_of({3.6, 0.0, -3.6}), 11U);
  EXPECT_EQ(ego_lane_of({3.6, 1e-9, -3.6}), 12U);
  EXPECT_EQ(ego_lane_of({3.6, -1e-9, -3.6}), 11U);
}

TEST(EgoLane, IsNoneBesideTheRoad) {
  EXPECT_EQ(ego_lane_of({}), 0U);
  EXPECT_EQ(ego_lane_of({5.4, 1.8}), 0U);
  EXPECT_EQ(ego_lane_of({-1.8, -5.4}), 0U);
}

TEST(EgoLane, IsNoneWhereItsBoundaryIsMissing) {
  LaneEstimate estimate = road_with({1.8, -1.8});
  estimate.boundaries.pop_back();
  EXPECT_EQ(ego_lane(estimate), nullptr);
}

TEST(FindInEstimate, GoesByIdAndSaysNothingForOthers) {
  const LaneEstimate estimate = road_with({5.4, 1.8, -1.8});
  ASSERT_NE(find_boundary(estimate, 2), nullptr);
  EXPECT_EQ(find_boundary(estimate, 2)->clothoid.lateral_offset, 1.8);
  EXPECT_EQ(find_boundary(estimate, 9), nullptr);
  ASSERT_NE(find_lane(estimate, 12), nullptr);
  EXPECT_EQ(find_lane(estimate, 12)->left_boundary, 2U);
  EXPECT_EQ(find_lane(estimate, 2), nullptr);
}

TEST(SamplePoints, LieEveryTwoMetresOnTheCurveUpToItsEnd) {
  Boundary boundary;
  boundary.clothoid = {1.8, 0.01, 1e-3, 1e-6};
  boundary.range_begin = -4;
  boundary.range_end = 7;
  sample_points(boundary);
  ASSERT_EQ(boundary.points.size(), 6U);
  EXPECT_DOUBLE_EQ(boundary.points.front().x, -4);
  EXPECT_DOUBLE_EQ(boundary.points.back().x, 6);
  for (std::size_t i = 0; i < boundary.points.size(); ++i) {
    EXPECT_DOUBLE_EQ(boundary.points[i].x, -4 + kPointSpacing * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(boundary.points[i].y, boundary.clothoid.y(boundary.points[i].x));
  }
}

TEST(SamplePoints, CarryTheClothoidsUncertainty) {
  Boundary boundary;
  boundary.covariance.diagonal() << 0.04, 1e-4, 0, 0;
  boundary.covariance(0, 1) = boundary.covariance(1, 0) = 1e-3;
  boundary.range_end = 10;
  sample_points(boundary);
  EXPECT_DOUBLE_EQ(boundary.points.front().sigma, 0.2);
  EXPECT_NEAR(boundary.points.back().sigma, std::sqrt(0.04 + 2 * 10 * 1e-3 + 100 * 1e-4), 1e-12);
}

TEST(SamplePoints, ReplaceWhatWasThereAndNeverGiveANegativeVariance) {
  Boundary boundary;
  boundary.points.resize(7);
  boundary.covariance(0, 0) = -1e-20;
  sample_points(boundary);
  ASSERT_EQ(boundary.points.size(), 1U);
  EXPECT_EQ(boundary.points.front().sigma, 0);
}

TEST(ProtectionAt, LiesBetweenThePointsThatVouch) {
  Boundary boundary;
  boundary.points = {{0, 0, 0.1, 0.4}, {2, 0, 0.1, 0.8}, {4, 0, 0.1, 0}, {6, 0, 0.1, 1}};
  EXPECT_DOUBLE_EQ(protection_at(boundary, 0), 0.4);
  EXPECT_DOUBLE_EQ(protection_at(boundary, 0.5), 0.5);
  EXPECT_EQ(protection_at(boundary, 3), 0) << "beside a point that vouches for nothing";
  EXPECT_EQ(protection_at(boundary, 7), 0) << "beyond the points";
  EXPECT_EQ(protection_at(Boundary{}, 0), 0);
}

template <typename Enumeration>
std::set<std::string> names_of(int count) {
  std::set<std::string> names;
  for (int i = 0; i < count; ++i) names.insert(to_string(static_cast<Enumeration>(i)));
  names.erase("unknown");
  return names;
}

TEST(Names, EveryValueHasItsOwn) {
  EXPECT_EQ(names_of<Source>(kSourceCount).size(), 6U);
  EXPECT_EQ(names_of<MarkingType>(5).size(), 4U) << "beside 'unknown'";
  EXPECT_EQ(names_of<MarkingColour>(3).size(), 2U) << "beside 'unknown'";
  EXPECT_EQ(names_of<EstimateStatus>(3).size(), 3U);
  EXPECT_EQ(names_of<StatusReason>(7).size(), 7U);
  EXPECT_EQ(names_of<Stage>(kStageCount).size(), 4U);
  EXPECT_STREQ(to_string(static_cast<Source>(200)), "unknown");
}

TEST(InputAccounting, AddsUp) {
  InputAccounting sum{1, 2, 3};
  sum += {10, 20, 30};
  EXPECT_EQ(sum, (InputAccounting{11, 22, 33}));
}

}  // namespace
}  // namespace lanefuse
