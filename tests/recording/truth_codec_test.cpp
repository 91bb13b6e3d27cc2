// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "osi3/osi_groundtruth.pb.h"
#include "random_recording.hpp"
#include "recording/true_frame_codec.hpp"
#include "recording/true_road_codec.hpp"

namespace lanefuse {
namespace {

using testing::below;

constexpr double kRounding = 1e-9;

/// A number as roads and cars have them.
double within(double limit) { return (below<int>(2'000'001) - 1'000'000) * 1e-6 * limit; }

Pose2 random_pose() { return {within(1e5), within(1e5), within(4)}; }

TrueObject random_true_object() {
  return {*rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 62), random_pose(), within(60),
          10 + within(9), 2 + within(1)};
}

void expect_near(const Pose2& a, const Pose2& b) {
  RC_ASSERT(std::abs(a.x - b.x) < kRounding);
  RC_ASSERT(std::abs(a.y - b.y) < kRounding);
  RC_ASSERT(a.heading == b.heading);
}

osi3::GroundTruth as_osi(const mcap::Bytes& bytes) {
  osi3::GroundTruth message;
  EXPECT_TRUE(message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
  return message;
}

RC_GTEST_PROP(TruthCodec, RoadComesBackExactly, ()) {
  const TrueRoad road{testing::some(testing::random_true_boundary), testing::some(testing::random_true_lane)};
  RC_ASSERT(fields(decode_true_road(encode_true_road(road, testing::random_time()))) == fields(road));
}

RC_GTEST_PROP(TruthCodec, FrameComesBackWithinRounding, ()) {
  const TrueFrame frame{testing::random_time(), random_pose(), within(60), within(1),
                        testing::some(random_true_object)};
  const TrueFrame back = decode_true_frame(encode_true_frame(frame), frame.time);
  RC_ASSERT(back.time == frame.time);
  expect_near(back.world_from_vehicle, frame.world_from_vehicle);
  RC_ASSERT(std::abs(back.speed - frame.speed) < kRounding);
  RC_ASSERT(back.yaw_rate == frame.yaw_rate);
  RC_ASSERT(back.objects.size() == frame.objects.size());
  for (std::size_t i = 0; i < frame.objects.size(); ++i) {
    RC_ASSERT(back.objects[i].id == frame.objects[i].id);
    expect_near(back.objects[i].world_from_object, frame.objects[i].world_from_object);
    RC_ASSERT(std::abs(back.objects[i].speed - frame.objects[i].speed) < kRounding);
    RC_ASSERT(back.objects[i].length == frame.objects[i].length);
    RC_ASSERT(back.objects[i].width == frame.objects[i].width);
  }
}

TEST(TruthCodec, OtherToolsFindTheMiddleOfAVehiclesBox) {
  TrueFrame frame;
  frame.objects = {{.id = 7, .world_from_object = {10, 5, M_PI / 2}, .speed = 20, .length = 4, .width = 2}};
  const osi3::GroundTruth message = as_osi(encode_true_frame(frame));
  ASSERT_EQ(message.moving_object_size(), 2);
  EXPECT_EQ(message.moving_object(0).id().value(), message.host_vehicle_id().value());
  const osi3::BaseMoving& base = message.moving_object(1).base();
  EXPECT_NEAR(base.position().x(), 10, kRounding);
  EXPECT_NEAR(base.position().y(), 7, kRounding);
  EXPECT_NEAR(base.velocity().x(), 0, kRounding);
  EXPECT_NEAR(base.velocity().y(), 20, kRounding);
}

TEST(TruthCodec, RefusesWhatIsNoTruth) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(encode_true_road({{TrueBoundary{}}, {}}, Time{}), Error);
  EXPECT_THROW(encode_true_frame({.world_from_vehicle = {kNan, 0, 0}}), Error);
  EXPECT_THROW(decode_true_frame(encode_true_road({}, Time{}), Time{}), Error) << "no host vehicle in it";
}

}  // namespace
}  // namespace lanefuse
