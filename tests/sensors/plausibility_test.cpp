// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "sensors/measurement.hpp"

namespace lanefuse {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kImpossible{kNan, kInfinity, -kInfinity, 1e308, -1e308};

/// That every impossible number makes `thing` implausible, wherever `member` puts it; the thing itself is
/// sound.
template <typename Thing, typename Member>
void expect_refused(const Thing& thing, Member member, const char* name) {
  ASSERT_TRUE(is_plausible(thing));
  for (const double value : kImpossible) {
    Thing damaged = thing;
    member(damaged) = value;
    EXPECT_FALSE(is_plausible(damaged)) << name << " = " << value;
  }
}

#define EXPECT_REFUSED(thing, member) \
  expect_refused(                     \
      thing, [](auto& t) -> double& { return t.member; }, #member)

Feature sound_feature() { return {40, 1.8, 0.01, 0.5}; }

ClothoidMeasurement sound_clothoid() {
  ClothoidMeasurement measurement;
  measurement.clothoid = {1.8, 0.01, 1e-4, 1e-7};
  measurement.covariance.diagonal() << 4e-3, 1e-5, 1e-9, 1e-14;
  measurement.range_end = 50;
  return measurement;
}

TEST(PlausibleFeature, HasNoImpossibleNumber) {
  EXPECT_REFUSED(sound_feature(), x);
  EXPECT_REFUSED(sound_feature(), y);
  EXPECT_REFUSED(sound_feature(), heading);
  EXPECT_REFUSED(sound_feature(), confidence);
  EXPECT_REFUSED(sound_feature(), covariance(0, 0));
  EXPECT_REFUSED(sound_feature(), covariance(2, 2));
  EXPECT_REFUSED(sound_feature(), covariance(0, 1));
}

TEST(PlausibleFeature, HasAConfidenceFromZeroToOne) {
  for (const double confidence : {0.0, 1.0}) {
    EXPECT_TRUE(is_plausible(Feature{40, 1.8, 0, confidence})) << confidence;
  }
  for (const double confidence : {-0.001, 1.001}) {
    EXPECT_FALSE(is_plausible(Feature{40, 1.8, 0, confidence})) << confidence;
  }
}

TEST(PlausibleFeature, HasASymmetricPositiveDefiniteCovariance) {
  Feature feature = sound_feature();
  feature.covariance(0, 1) = 0.1;
  EXPECT_FALSE(is_plausible(feature)) << "not symmetric";
  feature.covariance(1, 0) = 0.1;
  EXPECT_TRUE(is_plausible(feature));
  feature.covariance(0, 1) = feature.covariance(1, 0) = 1.1;
  EXPECT_FALSE(is_plausible(feature)) << "correlated more than wholly";
  feature.covariance.setZero();
  EXPECT_FALSE(is_plausible(feature)) << "sure of everything";
  feature.covariance = 1e-300 * Eigen::Matrix3d::Identity();
  EXPECT_FALSE(is_plausible(feature)) << "so sure that it would outvote all others";
}

TEST(PlausibleClothoid, HasNoImpossibleNumber) {
  EXPECT_REFUSED(sound_clothoid(), clothoid.lateral_offset);
  EXPECT_REFUSED(sound_clothoid(), clothoid.heading);
  EXPECT_REFUSED(sound_clothoid(), clothoid.curvature);
  EXPECT_REFUSED(sound_clothoid(), clothoid.curvature_rate);
  EXPECT_REFUSED(sound_clothoid(), range_begin);
  EXPECT_REFUSED(sound_clothoid(), range_end);
  EXPECT_REFUSED(sound_clothoid(), confidence);
  EXPECT_REFUSED(sound_clothoid(), covariance(0, 0));
  EXPECT_REFUSED(sound_clothoid(), covariance(3, 3));
}

TEST(PlausibleClothoid, MayBeSureOfSomeOfItsParameters) {
  ClothoidMeasurement measurement = sound_clothoid();
  measurement.covariance(3, 3) = 0;
  EXPECT_TRUE(is_plausible(measurement)) << "a camera that fits circles has no curvature rate";
  measurement.covariance(3, 3) = -1e-14;
  EXPECT_FALSE(is_plausible(measurement));
  measurement = sound_clothoid();
  measurement.covariance(2, 3) = measurement.covariance(3, 2) = 2 * std::sqrt(1e-9 * 1e-14);
  EXPECT_FALSE(is_plausible(measurement)) << "correlated more than wholly, however small the numbers";
}

TEST(PlausibleClothoid, EndsBehindItsBeginning) {
  ClothoidMeasurement measurement = sound_clothoid();
  measurement.range_begin = measurement.range_end;
  EXPECT_TRUE(is_plausible(measurement));
  measurement.range_begin = measurement.range_end + 0.1;
  EXPECT_FALSE(is_plausible(measurement));
}

TEST(PlausibleObject, HasNoImpossibleNumber) {
  const TrackedObject object{7, 40, 0, 0.01, 30};
  EXPECT_REFUSED(object, x);
  EXPECT_REFUSED(object, y);
  EXPECT_REFUSED(object, heading);
  EXPECT_REFUSED(object, speed);
  EXPECT_REFUSED(object, existence);
  EXPECT_REFUSED(object, covariance(1, 1));
}

TEST(PlausibleDetection, HasNoImpossibleNumberAndARangeAboveZero) {
  const RadarDetection detection{40, 0.1, -5};
  EXPECT_REFUSED(detection, range);
  EXPECT_REFUSED(detection, bearing);
  EXPECT_REFUSED(detection, range_rate);
  for (const double range : {0.0, -1.0}) EXPECT_FALSE(is_plausible(RadarDetection{range, 0, 0})) << range;
}

TEST(PlausibleMeasurement, IsReceivedAfterItWasMeasured) {
  const auto motion = [](std::int64_t measured, std::int64_t received) {
    return VehicleMotion{{from_nanoseconds(measured), from_nanoseconds(received)}, 30.0, 0.0};
  };
  EXPECT_FALSE(implausible(motion(5, 5)));
  EXPECT_FALSE(implausible(motion(5, 6)));
  EXPECT_EQ(implausible(motion(6, 5)), "received before it was measured");
}

TEST(PlausibleMeasurement, MovesLikeACar) {
  EXPECT_FALSE(implausible(VehicleMotion{})) << "a message may carry nothing";
  EXPECT_FALSE(implausible(VehicleMotion{{}, 60.0, -1.0, {{59, 61, 59, 61}}}));
  for (const double value : kImpossible) {
    EXPECT_TRUE(implausible(VehicleMotion{{}, value, 0.0}));
    EXPECT_TRUE(implausible(VehicleMotion{{}, 30.0, value}));
    EXPECT_TRUE(implausible(VehicleMotion{{}, 30.0, 0.0, {{30, 30, value, 30}}}));
  }
}

TEST(PlausibleMeasurement, SaysSensibleThingsOfPaintAndSharedErrors) {
  for (const double value : kImpossible) {
    EXPECT_TRUE(implausible(SerialLane{{}, {}, {}, value}));
    EXPECT_TRUE(implausible(MarkingFeatures{{}, {}, SharedError{SharedError::Kind::yaw, value}}));
  }
  EXPECT_TRUE(implausible(SerialLane{{}, {}, {}, 0.0}));
  EXPECT_FALSE(implausible(SerialLane{{}, {}, {}, 0.15}));
  EXPECT_FALSE(implausible(MarkingFeatures{{}, {}, SharedError{SharedError::Kind::yaw, 0}}));
  EXPECT_FALSE(implausible(RadarScan{}));
  EXPECT_FALSE(implausible(ObjectList{}));
}

}  // namespace
}  // namespace lanefuse
