// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sources/ego_path_source.hpp"
#include "sources/lane_width_filter.hpp"
#include "sources/source_under_test.hpp"

namespace lanefuse {
namespace {

using testing::kNow;
using testing::SourceUnderTest;

EgoPathConfig enabled() {
  EgoPathConfig config;
  config.enabled = true;
  return config;
}

TEST(EgoPathSource, TakesNoMeasurement) {
  EgoPathSource source(enabled());
  EXPECT_TRUE(testing::taken_by(source).empty());
}

TEST(EgoPathSource, StandsHalfALaneToEitherSideOfTheCar) {
  EgoPathSource source(enabled());
  SourceUnderTest test{source, {{kNow, {100, 200, 1}, 30, 0}}, LaneWidth{3.2, 0.1}};
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].source, Source::ego_path);
  EXPECT_EQ(sets[0].measured_at, kNow);
  EXPECT_EQ(sets[0].lane_width->mean, 3.2);
  ASSERT_EQ(sets[0].features.size(), 2U);
  const Feature& left = sets[0].features[0];
  const Feature& right = sets[0].features[1];
  EXPECT_EQ(left.side, Side::left);
  EXPECT_DOUBLE_EQ(left.y, 1.6);
  EXPECT_EQ(right.side, Side::right);
  EXPECT_DOUBLE_EQ(right.y, -1.6);
  EXPECT_EQ(left.x, 0);
  EXPECT_EQ(left.track_id, right.track_id);
  EXPECT_NE(left.track_id, kNoTrack);
  EXPECT_TRUE(is_plausible(left));
}

TEST(EgoPathSource, SaysNothingWhereTheCarMayBeAnywhere) {
  EgoPathSource source(enabled());
  EXPECT_TRUE((SourceUnderTest{source}.collect().empty())) << "no motion";
  EXPECT_TRUE((SourceUnderTest{source, {{kNow, {}, 2.9, 0}}}.collect().empty())) << "too slow";
  EXPECT_EQ((SourceUnderTest{source, {{kNow, {}, 3.1, 0}}}.collect().size()), 1U);
  EgoPathSource disabled({});
  EXPECT_TRUE((SourceUnderTest{disabled, {{kNow, {}, 30, 0}}}.collect().empty()))
      << "the paper has no such source";
}

FeatureSet lane(double left, double right, Time time = kNow, double heading = 0) {
  FeatureSet set;
  set.measured_at = time;
  for (const auto& [offset, side] : {std::pair{left, Side::left}, {right, Side::right}}) {
    ClothoidMeasurement measurement;
    measurement.clothoid = {offset, heading, 0, 0};
    measurement.covariance = 0.01 * Eigen::Matrix4d::Identity();
    measurement.side = side;
    set.clothoids.push_back(measurement);
  }
  return set;
}

TEST(LaneWidthFilter, KnowsNothingBeforeBothMarkingsWereSeen) {
  LaneWidthFilter filter;
  EXPECT_FALSE(filter.width(kNow));
  FeatureSet half = lane(1.8, -1.7);
  half.clothoids.pop_back();
  filter.update(half);
  EXPECT_FALSE(filter.width(kNow));
  filter.update(lane(1.8, -1.7));
  ASSERT_TRUE(filter.width(kNow));
  EXPECT_DOUBLE_EQ(filter.width(kNow)->mean, 3.5);
  EXPECT_GT(filter.width(kNow)->standard_deviation, 0.1);
  EXPECT_LT(filter.width(kNow)->standard_deviation, 0.3);
}

TEST(LaneWidthFilter, MeasuresAcrossTheLaneAndNotAcrossTheCar) {
  LaneWidthFilter filter;
  filter.update(lane(1.75, -1.75, kNow, 0.2));
  EXPECT_NEAR(filter.width(kNow)->mean, 3.5 / std::sqrt(1 + 0.04), 1e-9);
}

TEST(LaneWidthFilter, FollowsSlowly) {
  LaneWidthFilter filter;
  filter.update(lane(1.75, -1.75));
  filter.update(lane(2, -2));
  EXPECT_NEAR(filter.width(kNow)->mean, 3.525, 1e-9);
  for (int i = 0; i < 200; ++i) filter.update(lane(2, -2));
  EXPECT_NEAR(filter.width(kNow)->mean, 4, 0.001);
}

TEST(LaneWidthFilter, IgnoresWhatIsNoLane) {
  LaneWidthFilter filter;
  filter.update(lane(0.5, -0.5));
  filter.update(lane(4, -4));
  filter.update(lane(-1.75, 1.75));
  EXPECT_FALSE(filter.width(kNow));
}

TEST(LaneWidthFilter, AgesAndForgets) {
  LaneWidthFilter filter;
  filter.update(lane(1.75, -1.75));
  EXPECT_TRUE(filter.width(kNow + std::chrono::seconds(5)));
  EXPECT_FALSE(filter.width(kNow + std::chrono::milliseconds(5001)));
  EXPECT_FALSE(filter.width(kNow + std::chrono::seconds(1), std::chrono::milliseconds(999)));
  filter.reset();
  EXPECT_FALSE(filter.width(kNow));
}

}  // namespace
}  // namespace lanefuse
