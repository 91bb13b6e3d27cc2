// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/camera_view_codec.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "random_recording.hpp"

namespace lanefuse {
namespace {

using testing::number;

Mounting random_mounting() { return {number(), number(), number(), number(), number(), number()}; }

CameraView random_view() {
  CameraView view;
  view.sensor_id = 3;
  view.measured_at = testing::random_stamp().measured_at;
  view.fault = testing::any_of<ImageFault>(8);
  view.calibration = testing::any_of<CalibrationStatus>(3);
  view.pose = {random_mounting(), number(), testing::symmetric<4>(), number()};
  view.vehicles = testing::some([] {
    return VehicleBox{number(), number(), number(), number(), number(), number(), number(), number()};
  });
  view.windows = testing::some(
      [] { return SearchWindow{number(), number(), number(), testing::any_of<Side>(3), true, number()}; });
  view.bars = testing::some([] { return ImageBar{number(), number(), number(), true}; });
  return view;
}

RC_GTEST_PROP(CameraViewCodec, ViewsComeBackExactly, ()) {
  const CameraView view = random_view();
  RC_ASSERT(fields(decode_camera_view(encode_camera_view(view))) == fields(view));
}

RC_GTEST_PROP(CameraViewCodec, DamagedViewsAreDecodedOrRefused, ()) {
  mcap::Bytes bytes = encode_camera_view(random_view());
  const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
  bytes[at] ^= static_cast<std::byte>(*rc::gen::inRange(1, 256));
  try {
    decode_camera_view(bytes);
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace lanefuse
