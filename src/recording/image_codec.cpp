// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/image_codec.hpp"

#include <cassert>
#include <cstring>

#include "foxglove/camera_calibration.pb.h"
#include "foxglove/compressed_image.pb.h"
#include "recording/foxglove_fields.hpp"
#include "recording/message_bytes.hpp"

namespace lanefuse {

mcap::Bytes encode_camera_image(const CameraImage& image) {
  foxglove::CompressedImage message;
  put(image.stamp.measured_at, *message.mutable_timestamp());
  message.set_format(image.format);
  message.set_data(image.bytes.data(), image.bytes.size());
  message.set_frame_id(kVehicleFrame);
  return to_bytes(message);
}

CameraImage decode_camera_image(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<foxglove::CompressedImage>(bytes);
  CameraImage image{stamp, message.format(), {}};
  image.bytes.resize(message.data().size());
  if (!image.bytes.empty()) std::memcpy(image.bytes.data(), message.data().data(), image.bytes.size());
  return image;
}

mcap::Bytes encode_camera_calibration(const SensorDescription& sensor, Time time) {
  assert(sensor.camera);
  const CameraIntrinsics& camera = *sensor.camera;
  foxglove::CameraCalibration message;
  put(time, *message.mutable_timestamp());
  message.set_frame_id(sensor.name);
  message.set_width(static_cast<std::uint32_t>(camera.width));
  message.set_height(static_cast<std::uint32_t>(camera.height));
  message.set_distortion_model("plumb_bob");
  for (const double k : camera.distortion) message.add_d(k);
  for (const double k : {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0}) {
    message.add_k(k);
  }
  for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) message.add_r(r);
  for (const double p :
       {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0}) {
    message.add_p(p);
  }
  return to_bytes(message);
}

}  // namespace lanefuse
