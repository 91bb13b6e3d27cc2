// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/measurement_codec.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "random_recording.hpp"
#include "recording/topics.hpp"

namespace lanefuse {
namespace {

using testing::number;

/// What comes back of a measurement that is one message.
template <class T>
T round_trip(const T& measurement) {
  const auto messages = encode(measurement);
  RC_ASSERT(messages.size() == 1u);
  return std::get<T>(decoder_of(messages[0].topic)(messages[0].bytes, measurement.stamp));
}

RC_GTEST_PROP(MeasurementCodec, MotionComesBackExactly, ()) {
  const VehicleMotion motion{testing::random_stamp(), testing::maybe(number), testing::maybe(number), {}};
  RC_ASSERT(fields(round_trip(motion)) == fields(motion));
}

RC_GTEST_PROP(MeasurementCodec, WheelSpeedsComeBackExactly, ()) {
  VehicleMotion motion;
  motion.stamp = testing::random_stamp();
  motion.wheel_speeds = {number(), number(), number(), number()};
  RC_ASSERT(fields(round_trip(motion)) == fields(motion));
}

RC_GTEST_PROP(MeasurementCodec, SerialLaneComesBackExactly, ()) {
  const SerialLane lane = testing::random_serial_lane();
  RC_ASSERT(fields(round_trip(lane)) == fields(lane));
}

RC_GTEST_PROP(MeasurementCodec, MarkingFeaturesComeBackExactly, ()) {
  const MarkingFeatures markings = testing::random_marking_features();
  RC_ASSERT(fields(round_trip(markings)) == fields(markings));
}

RC_GTEST_PROP(MeasurementCodec, RadarScanComesBackExactly, ()) {
  const RadarScan scan{testing::random_stamp(), testing::some(testing::random_detection)};
  RC_ASSERT(fields(round_trip(scan)) == fields(scan));
}

RC_GTEST_PROP(MeasurementCodec, ObjectsComeBackExactly, ()) {
  const ObjectList list{testing::random_stamp(), testing::some(testing::random_object)};
  RC_ASSERT(fields(round_trip(list)) == fields(list));
}

RC_GTEST_PROP(MeasurementCodec, FixComesBackButForTheLastBitsOfItsDegrees, ()) {
  GnssInsFix fix{.stamp = testing::random_stamp(),
                 .latitude = *rc::gen::inRange(-1570, 1570) / 1000.0,
                 .longitude = *rc::gen::inRange(-3141, 3141) / 1000.0,
                 .height = number(),
                 .heading = number(),
                 .position_covariance = testing::symmetric<3>(),
                 .heading_sigma = number(),
                 .kind = testing::any_of<FixKind>(4)};
  const GnssInsFix back = round_trip(fix);
  RC_ASSERT(std::abs(back.latitude - fix.latitude) < 1e-15);
  RC_ASSERT(std::abs(back.longitude - fix.longitude) < 1e-15);
  fix.latitude = back.latitude;
  fix.longitude = back.longitude;
  RC_ASSERT(fields(back) == fields(fix));
}

RC_GTEST_PROP(MeasurementCodec, ImagesComeBackByteByByte, ()) {
  const auto numbers = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
  CameraImage image{testing::random_stamp(), "jpeg", {}};
  for (const std::uint8_t n : numbers) image.bytes.push_back(static_cast<std::byte>(n));
  RC_ASSERT(fields(round_trip(image)) == fields(image));
}

RC_GTEST_PROP(MeasurementCodec, AnyBytesAreDecodedOrRefused, ()) {
  const auto topic = *rc::gen::element<const char*>(topic::kVehicleMotion, topic::kWheelSpeeds,
                                                    topic::kSerialCamera, topic::kHighResolutionCamera,
                                                    topic::kRadar, topic::kObjects, topic::kGnssIns);
  const auto bytes = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
  try {
    decoder_of(topic)(std::as_bytes(std::span(bytes)), Stamp{});
  } catch (const Error& error) {
    RC_ASSERT(error.kind() == Error::Kind::input);
  }
}

RC_GTEST_PROP(MeasurementCodec, EveryCutOfAMessageIsDecodedOrRefused, ()) {
  const auto message = encode(testing::random_marking_features()).front();
  for (std::size_t size = 0; size < message.bytes.size(); ++size) {
    try {
      decoder_of(message.topic)(std::span(message.bytes).first(size), Stamp{});
    } catch (const Error& error) {
      RC_ASSERT(error.kind() == Error::Kind::input);
    }
  }
}

TEST(MeasurementCodec, MotionWithWheelSpeedsBecomesTwoMessages) {
  const VehicleMotion motion{{}, 20.0, {}, std::array{1.0, 2.0, 3.0, 4.0}};
  const auto messages = encode(motion);
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_STREQ(messages[0].topic, topic::kVehicleMotion);
  EXPECT_STREQ(messages[1].topic, topic::kWheelSpeeds);
}

TEST(MeasurementCodec, NumbersThatAreNoneReachTheirSource) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  MarkingFeatures markings;
  markings.features.resize(2);
  markings.features[1].x = kNan;
  const auto message = encode(markings).front();
  const auto back = std::get<MarkingFeatures>(decoder_of(message.topic)(message.bytes, Stamp{}));
  EXPECT_TRUE(is_plausible(Feature{.covariance = back.features[0].covariance}));
  EXPECT_FALSE(is_plausible(back.features[1]));
}

TEST(MeasurementCodec, ObjectBelowZeroIsRefused) {
  ObjectList list;
  list.objects.push_back({.id = -1});
  EXPECT_THROW(encode(list), Error);
}

TEST(MeasurementCodec, ListsLongerThanAnyRealOneAreRefused) {
  ObjectList list;
  list.objects.resize(257);
  const auto message = encode(list).front();
  EXPECT_THROW(decoder_of(message.topic)(message.bytes, Stamp{}), Error);
}

TEST(MeasurementCodec, TruthAndResultsAreNoMeasurements) {
  EXPECT_EQ(decoder_of(topic::kTrueFrame), nullptr);
  EXPECT_EQ(decoder_of(topic::kLanes), nullptr);
  EXPECT_EQ(decoder_of(topic::kCalibration), nullptr);
}

}  // namespace
}  // namespace lanefuse
