// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/rig_codec.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "foxglove/frame_transforms.pb.h"
#include "random_recording.hpp"

namespace lanefuse {
namespace {

using testing::number;

CameraIntrinsics random_intrinsics() {
  const auto positive = [] { return std::abs(number()) + 1; };
  return {testing::below(4000) + 1,
          testing::below(3000) + 1,
          positive(),
          positive(),
          number(),
          number(),
          {number(), number(), number(), number(), number()}};
}

RC_GTEST_PROP(RigCodec, RigComesBackExactly, ()) {
  Rig rig;
  for (std::uint32_t id = 0; id < testing::below<std::uint32_t>(6); ++id) {
    rig.sensors.push_back({id,
                           testing::any_of<SensorKind>(8),
                           *rc::gen::container<std::string>(rc::gen::inRange(' ', '~')),
                           {number(), number(), number(), number(), number(), number()},
                           testing::maybe(random_intrinsics)});
  }
  RC_ASSERT(decode_rig(encode_rig(rig)) == rig);
}

TEST(RigCodec, RefusesWhatIsNoRig) {
  const SensorDescription radar{3, SensorKind::long_range_radar, "front radar", {}};
  SensorDescription nowhere = radar;
  nowhere.mounting.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(decode_rig(encode_rig({{radar, radar}})), Error);
  EXPECT_THROW(decode_rig(encode_rig({{nowhere}})), Error);
}

TEST(RigCodec, RefusesALensThatIsNone) {
  const auto with = [](const CameraIntrinsics& camera) {
    return encode_rig({{{1, SensorKind::camera, "front", {}, camera}}});
  };
  const CameraIntrinsics sound{640, 480, 500, 500, 320, 240, {}};
  EXPECT_NO_THROW(decode_rig(with(sound)));
  for (const auto& spoil : std::vector<void (*)(CameraIntrinsics&)>{
           [](CameraIntrinsics& c) { c.width = 0; }, [](CameraIntrinsics& c) { c.height = 1'000'000; },
           [](CameraIntrinsics& c) { c.fx = -1; },
           [](CameraIntrinsics& c) { c.distortion[4] = std::numeric_limits<double>::infinity(); }}) {
    CameraIntrinsics camera = sound;
    spoil(camera);
    EXPECT_THROW(decode_rig(with(camera)), Error);
  }
}

TEST(RigCodec, ViewersSeeWhereTheSensorsSit) {
  const Rig rig{{{1, SensorKind::long_range_radar, "front radar", {0.9, 0.1, 0.4, 0, 0, M_PI / 2}}}};
  const mcap::Bytes bytes = encode_transforms(rig, Time{});
  foxglove::FrameTransforms message;
  ASSERT_TRUE(message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
  ASSERT_EQ(message.transforms_size(), 1);
  EXPECT_EQ(message.transforms(0).parent_frame_id(), "vehicle");
  EXPECT_EQ(message.transforms(0).child_frame_id(), "front radar");
  EXPECT_EQ(message.transforms(0).translation().x(), 0.9);
  EXPECT_NEAR(message.transforms(0).rotation().z(), std::sin(M_PI / 4), 1e-12);
}

}  // namespace
}  // namespace lanefuse
