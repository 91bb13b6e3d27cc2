// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/object_source.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sources/source_under_test.hpp"
#include "support/radar_scene.hpp"

namespace lanefuse {
namespace {

using testing::kStamp;
using testing::SourceUnderTest;

TrackedObject vehicle(std::int64_t id, double x) {
  TrackedObject object{id, x, 0, 0, 30};
  object.movement = MovementState::moving;
  object.seen_by_radar = object.seen_by_camera = true;
  return object;
}

TEST(ObjectSource, TakesScansAndObjectListsOnly) {
  ObjectSource source({});
  EXPECT_THAT(testing::taken_by(source), ::testing::ElementsAre(3, 4));
}

TEST(ObjectSource, RejectsTheBadAndKeepsSilentOnThoseWhoMayNotBearWitness) {
  ObjectSource source({});
  SourceUnderTest test{source};
  TrackedObject damaged = vehicle(2, std::numeric_limits<double>::quiet_NaN());
  TrackedObject unverified = vehicle(3, 60);
  unverified.seen_by_camera = false;
  EXPECT_EQ(test.add(ObjectList{kStamp, {vehicle(1, 40), damaged, unverified}}), (InputAccounting{2, 1, 0}));
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].source, Source::objects);
  EXPECT_EQ(sets[0].measured_at, kStamp.measured_at);
  ASSERT_EQ(sets[0].features.size(), 2U);
  EXPECT_EQ(sets[0].features[0].track_id, 1);
  EXPECT_EQ(sets[0].features[1].track_id, 1);
}

TEST(ObjectSource, TakesTheLanesWidthFromTheCameraWhereItSeesOne) {
  ObjectSource source({});
  SourceUnderTest test{source};
  test.add(ObjectList{kStamp, {vehicle(1, 40)}});
  test.lane_width = LaneWidth{3.0, 0.1};
  test.add(ObjectList{kStamp, {vehicle(1, 40)}});
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0].lane_width->mean, 3.5) << "the usual one of German motorways";
  EXPECT_DOUBLE_EQ(sets[0].features[0].y, 1.75);
  EXPECT_EQ(sets[1].lane_width->mean, 3.0);
  EXPECT_DOUBLE_EQ(sets[1].features[0].y, 1.5);
}

TEST(ObjectSource, AnEmptyListIsStillAWordOfTheSensor) {
  ObjectSource source({});
  SourceUnderTest test{source};
  EXPECT_EQ(test.add(ObjectList{kStamp, {}}), InputAccounting{});
  EXPECT_EQ(test.collect().size(), 1U);
}

TEST(ObjectSource, DropsScansOfUnknownRadarsAndWithoutMotion) {
  ObjectSource source({});
  SourceUnderTest test{source};
  RadarScan scan{kStamp, {RadarDetection{40, 0, 0}, RadarDetection{-40, 0, 0}}};
  EXPECT_EQ(test.add(scan), (InputAccounting{0, 1, 1})) << "no motion";
  test.motion = {{kStamp.measured_at, {}, 30, 0}};
  scan.stamp.sensor_id = 99;
  EXPECT_EQ(test.add(scan), (InputAccounting{0, 1, 1})) << "no such radar";
  scan.stamp.sensor_id = kStamp.sensor_id;
  EXPECT_EQ(test.add(scan), (InputAccounting{1, 1, 0}));
  EXPECT_EQ(test.add(scan), (InputAccounting{0, 1, 1})) << "twice";
  scan.stamp.measured_at -= std::chrono::milliseconds(400);
  EXPECT_EQ(test.add(scan), (InputAccounting{0, 1, 1})) << "from long ago";
}

/// A vehicle followed for two seconds by the radar that sits here; where its track then is.
Feature left_feature_seen_from(const Mounting& mounting) {
  ObjectSourceConfig config;
  config.witness.rule = WitnessRule::radar_only;
  ObjectSource source(config);
  const testing::RadarCar car{15, 0.2, {mounting.x, mounting.y, mounting.yaw}};
  const testing::RoadUser user{{40, 10}, {20, 8}};
  const Rig rig{{{1, SensorKind::long_range_radar, "", mounting}}};
  std::vector<FeatureSet> sets;
  for (int i = 0; i <= 40; ++i) {
    const double seconds = i * testing::kScanPeriod;
    const std::vector<MotionSample> motion{
        {testing::scan_time(seconds), car.pose(seconds), car.speed, car.yaw_rate}};
    sets.clear();
    source.add(car.scan({user}, seconds), {rig, motion, {}});
    source.collect(testing::scan_time(seconds), {rig, motion, {}}, sets);
  }
  EXPECT_EQ(sets.size(), 1U);
  return sets.empty() || sets[0].features.empty() ? Feature{} : sets[0].features[0];
}

TEST(ObjectSource, KnowsWhereTheRadarSits) {
  const Feature seen = left_feature_seen_from({});
  ASSERT_GT(seen.x, 40);
  for (const Mounting& mounting : {Mounting{4, 0, 0.5}, Mounting{4, -1, 0.5, 0, 0, 0.6}}) {
    const Feature feature = left_feature_seen_from(mounting);
    EXPECT_NEAR(feature.x, seen.x, 0.02);
    EXPECT_NEAR(feature.y, seen.y, 0.06);
    EXPECT_NEAR(feature.heading, seen.heading, 0.005);
  }
}

TEST(ObjectSource, ForgetsOnReset) {
  ObjectSource source({});
  SourceUnderTest test{source};
  test.add(ObjectList{kStamp, {vehicle(1, 40)}});
  source.reset();
  EXPECT_TRUE(test.collect().empty());
}

}  // namespace
}  // namespace lanefuse
