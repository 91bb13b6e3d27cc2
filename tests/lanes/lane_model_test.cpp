// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/lane_model.hpp"

#include <tuple>

#include <gtest/gtest.h>

#include "lanes/marking_features.hpp"

namespace lanefuse {
namespace {

using testing::Paint;
using testing::road_of;

/// A straight road along x in the world, seen by a car that may stand anywhere across it.
class Road : public ::testing::Test {
 protected:
  /// One cycle: the car moves on by `dx` and to `y`; the markings are seen where they are.
  void cycle(double y = 0, double dx = 1.2, const Paint& paint = {}) {
    std::vector<double> offsets;
    for (const double marking : markings_) offsets.push_back(marking - y);
    fused_ = road_of({}, offsets, paint);
    model_.process(fused_, {dx, y - y_, 0}, estimate_);
    y_ = y;
  }
  void cycles(int count, double y = 0) {
    for (int i = 0; i < count; ++i) cycle(y);
  }
  void blind_cycle() {
    fused_.clear();
    model_.process(fused_, {1.2, 0, 0}, estimate_);
  }
  [[nodiscard]] std::vector<std::uint64_t> boundary_ids() const {
    std::vector<std::uint64_t> ids;
    for (const Boundary& boundary : estimate_.boundaries) ids.push_back(boundary.id);
    return ids;
  }

  LaneModelConfig config_;
  LaneModel model_{config_};
  LaneEstimate estimate_;
  std::vector<double> markings_{5.4, 1.8, -1.8};
  std::vector<Feature> fused_;
  double y_ = 0;
};

TEST_F(Road, HasItsBoundariesFromLeftToRight) {
  cycles(30);
  ASSERT_EQ(estimate_.boundaries.size(), 3U);
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_NEAR(estimate_.boundaries[b].clothoid.lateral_offset, markings_[b], 0.01);
    EXPECT_NEAR(estimate_.boundaries[b].clothoid.y(80), markings_[b], 0.02);
    EXPECT_GT(estimate_.boundaries[b].confidence, 0.9);
    EXPECT_EQ(estimate_.boundaries[b].support[static_cast<std::size_t>(Source::high_resolution_camera)], 40);
  }
}

TEST_F(Road, LinksItsLanesToTheirNeighbours) {
  markings_ = {5.4, 1.8, -1.8, -5.4};
  cycles(5);
  ASSERT_EQ(estimate_.lanes.size(), 3U);
  const auto& [left, ego, right] = std::tie(estimate_.lanes[0], estimate_.lanes[1], estimate_.lanes[2]);
  EXPECT_FALSE(left.left_lane);
  EXPECT_EQ(left.right_lane, ego.id);
  EXPECT_EQ(ego.left_lane, left.id);
  EXPECT_EQ(ego.right_lane, right.id);
  EXPECT_EQ(right.left_lane, ego.id);
  EXPECT_FALSE(right.right_lane);
  EXPECT_EQ(left.right_boundary, ego.left_boundary);
  EXPECT_EQ(ego_lane(estimate_)->id, ego.id);
}

TEST_F(Road, HasNoLaneWhereAGapIsTooWideOrTooNarrow) {
  markings_ = {8.0, 1.8, -1.8, -3.9};
  cycles(5);
  ASSERT_EQ(estimate_.boundaries.size(), 4U);
  ASSERT_EQ(estimate_.lanes.size(), 1U);
  EXPECT_FALSE(estimate_.lanes[0].left_lane);
  EXPECT_FALSE(estimate_.lanes[0].right_lane);
}

TEST_F(Road, KeepsItsNamesThroughOurLaneChange) {
  cycles(20);
  const auto boundaries = boundary_ids();
  const std::uint64_t before = ego_lane(estimate_)->id;
  const std::uint64_t beside = *ego_lane(estimate_)->left_lane;
  for (int i = 1; i <= 100; ++i) {
    cycle(3.6 * i / 100);
    EXPECT_EQ(boundary_ids(), boundaries) << i;
    ASSERT_EQ(estimate_.lanes.size(), 2U);
  }
  EXPECT_EQ(ego_lane(estimate_)->id, beside) << "the role changes, not the name";
  EXPECT_EQ(*ego_lane(estimate_)->right_lane, before);
}

TEST_F(Road, ForgetsABoundaryAfterTwelveMisses) {
  cycles(20);
  markings_ = {5.4, 1.8};
  cycles(12);
  EXPECT_EQ(estimate_.boundaries.size(), 3U);
  cycles(1);
  EXPECT_EQ(estimate_.boundaries.size(), 2U);
}

TEST_F(Road, FoundsALostBoundaryAnewUnderANewName) {
  cycles(20);
  const auto before = boundary_ids();
  markings_ = {5.4, 1.8};
  cycles(13);
  markings_ = {5.4, 1.8, -1.8};
  cycles(1);
  ASSERT_EQ(estimate_.boundaries.size(), 3U);
  EXPECT_EQ(estimate_.boundaries[0].id, before[0]);
  EXPECT_GT(estimate_.boundaries[2].id, 3U);
}

TEST_F(Road, ForgetsTheYoungerOfTwoThatMerge) {
  markings_ = {1.8, -1.8};
  cycles(10);
  markings_ = {1.8, -1.8, -4.5};
  cycles(10);
  ASSERT_EQ(estimate_.boundaries.size(), 3U);
  const std::uint64_t young = estimate_.boundaries[2].id;
  for (double outer = -4.5; outer < -2; outer += 0.01) {
    markings_ = {1.8, -1.8, outer};
    cycle();
  }
  EXPECT_EQ(estimate_.boundaries.size(), 2U);
  EXPECT_EQ(find_boundary(estimate_, young), nullptr);
}

TEST_F(Road, IsSeenLessFarTheLessIsKnown) {
  cycles(40);
  const double sure = estimate_.boundaries[1].range_end;
  const double sigma_sure = estimate_.boundaries[1].points[30].sigma;
  for (int i = 0; i < 12; ++i) blind_cycle();
  ASSERT_FALSE(estimate_.boundaries.empty());
  EXPECT_GT(estimate_.boundaries[1].points[30].sigma, sigma_sure);
  EXPECT_LT(estimate_.boundaries[1].range_end, sure);
  for (const BoundaryPoint& point : estimate_.boundaries[1].points) EXPECT_LE(point.sigma, config_.sigma_max);
}

TEST_F(Road, TellsHowItIs) {
  blind_cycle();
  EXPECT_EQ(estimate_.status, EstimateStatus::invalid);
  EXPECT_EQ(estimate_.reason, StatusReason::warming_up);
  cycles(2);
  EXPECT_EQ(estimate_.status, EstimateStatus::ok);
  EXPECT_EQ(estimate_.reason, StatusReason::none);
  blind_cycle();
  EXPECT_EQ(estimate_.status, EstimateStatus::degraded);
  EXPECT_EQ(estimate_.reason, StatusReason::no_road_course);
  EXPECT_EQ(estimate_.lanes.size(), 2U) << "the lanes are predicted";
  model_.reset();
  cycles(2, 9);  // beside the road
  EXPECT_EQ(estimate_.status, EstimateStatus::degraded);
  EXPECT_EQ(estimate_.reason, StatusReason::no_ego_lane);
}

TEST_F(Road, ExplainsWhatBecameOfEachFeature) {
  cycles(5);
  auto fused = road_of({}, {5.4, 1.8, -1.8});
  for (int i = 0; i < 5; ++i) fused.push_back({20.0 + i, 12, 0.2, 0.5});
  fused.push_back({-10, 0, 0, 0.5});
  model_.process(fused, {1.2, 0, 0}, estimate_);
  DebugView view;
  model_.explain(fused, view);
  ASSERT_EQ(view.features.size(), fused.size());
  for (std::size_t i = 0; i < 120; ++i) {
    EXPECT_TRUE(view.features[i].in_base_fit);
    EXPECT_EQ(view.features[i].boundary, estimate_.boundaries[i / 40].id);
  }
  for (std::size_t i = 120; i < 125; ++i) {
    EXPECT_TRUE(view.features[i].outlier);
    EXPECT_EQ(view.features[i].boundary, 0U);
  }
  EXPECT_FALSE(view.features[125].in_base_fit);
  EXPECT_FALSE(view.features[125].outlier);
  ASSERT_TRUE(view.base_clothoid);
  EXPECT_NEAR(view.base_clothoid->y(80), 0, 0.05);
}

TEST_F(Road, NamesNoBoundaryThatItHasForgotten) {
  markings_ = {1.8, -1.8};
  cycles(10);
  markings_ = {1.8, -1.8, -4.5};
  cycles(10);
  for (double outer = -4.5; outer < -2; outer += 0.01) {
    markings_ = {1.8, -1.8, outer};
    cycle();
    DebugView view;
    model_.explain(fused_, view);
    for (const FusedFeature& feature : view.features) {
      EXPECT_TRUE(feature.boundary == 0 || find_boundary(estimate_, feature.boundary)) << outer;
    }
  }
}

TEST_F(Road, StartsAfreshOnReset) {
  cycles(10);
  model_.reset();
  cycles(1);
  ASSERT_EQ(estimate_.boundaries.size(), 3U);
  for (const Boundary& boundary : estimate_.boundaries) EXPECT_LE(boundary.id, 3U);
}

}  // namespace
}  // namespace lanefuse
