// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sources/high_resolution_camera_source.hpp"
#include "sources/serial_camera_source.hpp"
#include "sources/source_under_test.hpp"

namespace lanefuse {
namespace {

using testing::kStamp;
using testing::SourceUnderTest;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ClothoidMeasurement clothoid_at(double offset) {
  ClothoidMeasurement measurement;
  measurement.clothoid.lateral_offset = offset;
  measurement.covariance.diagonal() << 4e-3, 1e-5, 1e-9, 1e-14;
  measurement.range_end = 40;
  return measurement;
}

TEST(SerialCameraSource, TakesSerialLanesOnly) {
  SerialCameraSource source({});
  EXPECT_THAT(testing::taken_by(source), ::testing::ElementsAre(1));
}

TEST(SerialCameraSource, MovesInnerEdgesOutwardToTheCentreOfThePaint) {
  SerialCameraSource source({});
  SourceUnderTest test{source};
  EXPECT_EQ(test.add(SerialLane{kStamp, clothoid_at(1.7), clothoid_at(-1.8), 0.3}),
            (InputAccounting{2, 0, 0}));
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].source, Source::serial_camera);
  EXPECT_EQ(sets[0].sensor_id, kStamp.sensor_id);
  EXPECT_EQ(sets[0].measured_at, kStamp.measured_at);
  ASSERT_EQ(sets[0].clothoids.size(), 2U);
  EXPECT_DOUBLE_EQ(sets[0].clothoids[0].clothoid.lateral_offset, 1.85);
  EXPECT_EQ(sets[0].clothoids[0].side, Side::left);
  EXPECT_DOUBLE_EQ(sets[0].clothoids[1].clothoid.lateral_offset, -1.95);
  EXPECT_EQ(sets[0].clothoids[1].side, Side::right);
}

TEST(CameraSources, KeepLabels) {
  SerialCameraSource serial({});
  SourceUnderTest lanes{serial};
  SerialLane lane{kStamp, clothoid_at(1.7), clothoid_at(-1.8), {}};
  lane.left->label = 2;
  lanes.add(lane);
  const auto clothoids = lanes.collect().at(0).clothoids;
  ASSERT_EQ(clothoids.size(), 2U);
  EXPECT_EQ(clothoids[0].label, 2);
  EXPECT_EQ(clothoids[1].label, kNoLabel);

  HighResolutionCameraSource camera({});
  SourceUnderTest markings{camera};
  MarkingFeatures seen{
      kStamp, {Feature{.x = 30, .confidence = 0.5}, Feature{.x = 40, .confidence = 0.5}}, {}};
  seen.features[0].label = 3;
  seen.features[1].label = kNoLine;
  markings.add(seen);
  const auto features = markings.collect().at(0).features;
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[0].label, 3);
  EXPECT_EQ(features[1].label, kNoLine);
}

TEST(SerialCameraSource, TakesTheConfiguredWidthAndInflation) {
  SerialCameraConfig config;
  config.marking_width = 0.2;
  config.covariance_inflation = 4;
  SerialCameraSource source(config);
  SourceUnderTest test{source};
  test.add(SerialLane{kStamp, {}, clothoid_at(-1.8), {}});
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 1U);
  ASSERT_EQ(sets[0].clothoids.size(), 1U);
  EXPECT_DOUBLE_EQ(sets[0].clothoids[0].clothoid.lateral_offset, -1.9);
  EXPECT_DOUBLE_EQ(sets[0].clothoids[0].covariance(0, 0), 4 * 4e-3);
}

TEST(SerialCameraSource, RejectsOnlyTheBadMarking) {
  SerialCameraSource source({});
  SourceUnderTest test{source};
  EXPECT_EQ(test.add(SerialLane{kStamp, clothoid_at(kNan), clothoid_at(-1.8), {}}),
            (InputAccounting{1, 1, 0}));
  ClothoidMeasurement endless = clothoid_at(1.8);
  endless.range_begin = -1e308;
  EXPECT_EQ(test.add(SerialLane{kStamp, endless, {}, {}}), (InputAccounting{0, 1, 0}));
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 1U) << "a lane without a good marking is no set";
  ASSERT_EQ(sets[0].clothoids.size(), 1U);
  EXPECT_EQ(sets[0].clothoids[0].side, Side::right);
}

TEST(SerialCameraSource, HandsOverOnceAndForgetsOnReset) {
  SerialCameraSource source({});
  SourceUnderTest test{source};
  test.add(SerialLane{kStamp, clothoid_at(1.8), {}, {}});
  EXPECT_EQ(test.collect().size(), 1U);
  EXPECT_TRUE(test.collect().empty());
  test.add(SerialLane{kStamp, clothoid_at(1.8), {}, {}});
  source.reset();
  EXPECT_TRUE(test.collect().empty());
}

TEST(HighResolutionCameraSource, TakesMarkingFeaturesOnly) {
  HighResolutionCameraSource source({});
  EXPECT_THAT(testing::taken_by(source), ::testing::ElementsAre(2));
}

TEST(HighResolutionCameraSource, HandsFeaturesOverAsTheyAre) {
  HighResolutionCameraSource source({});
  SourceUnderTest test{source};
  Feature bar{80, -5, 0.02, 0.7};
  bar.covariance(1, 1) = 0.04;
  bar.marking.type = MarkingType::dashed;
  bar.track_id = 9;
  bar.side = Side::left;
  const SharedError leaning{SharedError::Kind::pitch, 0.001};
  test.add(MarkingFeatures{kStamp, {bar}, leaning});
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 1U);
  ASSERT_TRUE(sets[0].shared_error);
  EXPECT_EQ(sets[0].shared_error->sigma, 0.001);
  EXPECT_FALSE(sets[0].lane_width);
  ASSERT_EQ(sets[0].features.size(), 1U);
  const Feature& feature = sets[0].features[0];
  EXPECT_EQ(feature.x, 80);
  EXPECT_EQ(feature.covariance(1, 1), 0.04);
  EXPECT_EQ(feature.marking, bar.marking);
  EXPECT_EQ(feature.source, Source::high_resolution_camera);
  EXPECT_EQ(feature.track_id, kNoTrack) << "paint is no vehicle";
  EXPECT_EQ(feature.side, Side::none);
}

TEST(HighResolutionCameraSource, RejectsTheBadAndDropsTheFar) {
  HighResolutionCameraSource source({});
  SourceUnderTest test{source};
  Feature not_definite{50, 0, 0, 0.5};
  not_definite.covariance(0, 1) = not_definite.covariance(1, 0) = 2;
  const MarkingFeatures markings{kStamp,
                                 {Feature{50, 0, 0, 0.5}, Feature{kNan, 0, 0, 0.5}, not_definite,
                                  Feature{130, 0, 0, 0.5}, Feature{130.1, 0, 0, 0.5}}};
  EXPECT_EQ(test.add(markings), (InputAccounting{2, 2, 1}));
  const auto sets = test.collect();
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].features.size(), 2U);
}

TEST(HighResolutionCameraSource, HandsOverOnceAndForgetsOnReset) {
  HighResolutionCameraSource source({});
  SourceUnderTest test{source};
  test.add(MarkingFeatures{kStamp, {Feature{50, 0, 0, 0.5}}});
  EXPECT_EQ(test.collect().size(), 1U);
  EXPECT_TRUE(test.collect().empty());
  test.add(MarkingFeatures{kStamp, {Feature{50, 0, 0, 0.5}}});
  source.reset();
  EXPECT_TRUE(test.collect().empty());
}

}  // namespace
}  // namespace lanefuse
