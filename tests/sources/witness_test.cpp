// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/witness.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_values.hpp"

namespace lanefuse {
namespace {

using testing::between;

constexpr double kDegree = std::numbers::pi / 180;

/// Verified by both sensors, driving ahead in our direction.
TrackedObject sound_witness() {
  TrackedObject object{7, 40, 3.5, 0.01, 30};
  object.movement = MovementState::moving;
  object.seen_by_radar = object.seen_by_camera = true;
  return object;
}

bool bears_witness(const TrackedObject& object, WitnessRule rule = WitnessRule::radar_and_camera) {
  WitnessConfig config;
  config.rule = rule;
  return is_witness(object, config);
}

TEST(WitnessRule, AsksForTheSensorsThatItNames) {
  for (const bool radar : {false, true}) {
    for (const bool camera : {false, true}) {
      TrackedObject object = sound_witness();
      object.seen_by_radar = radar;
      object.seen_by_camera = camera;
      EXPECT_EQ(bears_witness(object, WitnessRule::radar_and_camera), radar && camera);
      EXPECT_EQ(bears_witness(object, WitnessRule::radar_only), radar);
    }
  }
}

TEST(WitnessRule, AsksForADrivingVehicle) {
  TrackedObject object = sound_witness();
  for (const auto& [movement, expected] : {std::pair{MovementState::moving, true},
                                           {MovementState::unknown, true},
                                           {MovementState::stationary, false},
                                           {MovementState::stopped, false}}) {
    object.movement = movement;
    EXPECT_EQ(bears_witness(object), expected) << static_cast<int>(movement);
  }
  object = sound_witness();
  object.speed = 3;
  EXPECT_FALSE(bears_witness(object));
  object.speed = 3.01;
  EXPECT_TRUE(bears_witness(object));
}

TEST(WitnessRule, AsksForAVehicleAheadAndNear) {
  TrackedObject object = sound_witness();
  for (const auto& [x, expected] :
       {std::pair{-10.0, false}, {2.0, false}, {2.1, true}, {149.0, true}, {150.0, false}}) {
    object.x = x;
    EXPECT_EQ(bears_witness(object), expected) << x;
  }
}

TEST(WitnessRule, AsksForAVehicleThatFollowsTheRoad) {
  TrackedObject object = sound_witness();
  for (const auto& [degrees, expected] :
       {std::pair{14.9, true}, {-14.9, true}, {15.1, false}, {-15.1, false}, {180.0, false}, {359.0, true}}) {
    object.heading = degrees * kDegree;
    EXPECT_EQ(bears_witness(object), expected) << degrees;
  }
}

TEST(WitnessRule, BelievesNothingThatIsNoNumber) {
  for (double TrackedObject::*member : {&TrackedObject::x, &TrackedObject::heading, &TrackedObject::speed}) {
    TrackedObject object = sound_witness();
    object.*member = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(bears_witness(object));
  }
}

RC_GTEST_PROP(WitnessFeatures, StandHalfALaneLeftAndRightOfTheVehicle, ()) {
  TrackedObject object = sound_witness();
  object.x = *between(5, 140);
  object.y = *between(-15, 15);
  object.heading = *between(-0.26, 0.26);
  object.existence = *between(0, 1);
  const LaneWidth width{*between(2.5, 4.5), 0.2};
  const WitnessConfig config;
  std::vector<Feature> features(1);
  add_witness_features(object, width, config, features);
  RC_ASSERT(features.size() == 3U);
  RC_ASSERT(features[1].side == Side::left);
  RC_ASSERT(features[2].side == Side::right);
  for (const Feature& feature : {features[1], features[2]}) {
    const Eigen::Vector2d offset(feature.x - object.x, feature.y - object.y);
    const Eigen::Vector2d along(std::cos(object.heading), std::sin(object.heading));
    const double to_left = along.x() * offset.y() - along.y() * offset.x();
    RC_ASSERT(std::abs(offset.dot(along)) < 1e-9);
    RC_ASSERT(std::abs(to_left - (feature.side == Side::left ? 0.5 : -0.5) * width.mean) < 1e-9);
    RC_ASSERT(feature.heading == object.heading);
    RC_ASSERT(feature.track_id == object.id);
    RC_ASSERT(feature.source == Source::objects);
    RC_ASSERT(std::abs(feature.confidence - config.confidence * object.existence) < 1e-12);
  }
}

TEST(WitnessFeatures, AddTheDriversSpreadAcrossTheLane) {
  TrackedObject object = sound_witness();
  object.heading = 0.2;
  object.covariance = Eigen::Vector3d(0.5, 0.1, 1e-4).asDiagonal();
  const WitnessConfig config;
  std::vector<Feature> features;
  add_witness_features(object, {}, config, features);
  const Eigen::Matrix3d own = rotate_covariance(features[0].covariance, -object.heading);
  const Eigen::Matrix3d before = rotate_covariance(object.covariance, -object.heading);
  EXPECT_NEAR(own(0, 0), before(0, 0), 1e-12) << "along the lane nothing is added";
  EXPECT_NEAR(own(0, 1), before(0, 1), 1e-12);
  EXPECT_NEAR(own(1, 1), before(1, 1) + std::pow(config.driver_sigma, 2), 1e-12);
  EXPECT_NEAR(own(2, 2), 1e-4 + std::pow(config.driver_heading_deg * kDegree, 2), 1e-12);
  EXPECT_EQ(features[0].covariance, features[1].covariance);
}

TEST(WitnessFeatures, EachSideIsOfItsOwnLine) {
  TrackedObject object = sound_witness();
  object.left_label = 1;
  object.right_label = 2;
  std::vector<Feature> features;
  add_witness_features(object, {}, {}, features);
  ASSERT_EQ(features.size(), 2U);
  for (const Feature& feature : features) EXPECT_EQ(feature.label, feature.side == Side::left ? 1 : 2);
  features.clear();
  add_witness_features(sound_witness(), {}, {}, features);
  for (const Feature& feature : features) EXPECT_EQ(feature.label, kNoLabel);
}

}  // namespace
}  // namespace lanefuse
