// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/rig_codec.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "foxglove/frame_transforms.pb.h"
#include "lanefuse/rig.pb.h"
#include "recording/foxglove_fields.hpp"
#include "recording/message_bytes.hpp"
#include "recording/mounting_fields.hpp"

namespace lanefuse {
namespace {

void put(const CameraIntrinsics& camera, v1::CameraIntrinsics& message) {
  message.set_width(static_cast<std::uint32_t>(camera.width));
  message.set_height(static_cast<std::uint32_t>(camera.height));
  message.set_fx(camera.fx);
  message.set_fy(camera.fy);
  message.set_cx(camera.cx);
  message.set_cy(camera.cy);
  for (const double k : camera.distortion) message.add_distortion(k);
}

CameraIntrinsics take(const v1::CameraIntrinsics& message) {
  constexpr std::uint32_t kLargest = 65'535;  // [px]
  const std::string type = message.GetTypeName();
  if (message.width() == 0 || message.height() == 0 || message.width() > kLargest ||
      message.height() > kLargest) {
    refuse(type, "its image has no size that a camera's has");
  }
  CameraIntrinsics camera{static_cast<int>(message.width()),
                          static_cast<int>(message.height()),
                          finite(message.fx(), type),
                          finite(message.fy(), type),
                          finite(message.cx(), type),
                          finite(message.cy(), type),
                          {}};
  if (!(camera.fx > 0 && camera.fy > 0)) refuse(type, "its focal length is not positive");
  if (message.distortion_size() != static_cast<int>(camera.distortion.size())) {
    refuse(type, "it has not five numbers of distortion");
  }
  for (int i = 0; i < message.distortion_size(); ++i) {
    camera.distortion[static_cast<std::size_t>(i)] = finite(message.distortion(i), type);
  }
  return camera;
}

SensorDescription take(const v1::Sensor& message) {
  if (!v1::SensorKind_IsValid(message.kind())) refuse(message.GetTypeName(), "its kind is unknown");
  SensorDescription sensor{message.id(), static_cast<SensorKind>(message.kind()), message.name(),
                           lanefuse::take(message.mounting())};
  if (message.has_camera()) sensor.camera = take(message.camera());
  return sensor;
}

Eigen::Quaterniond rotation_of(const Mounting& mounting) {
  return Eigen::AngleAxisd(mounting.yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(mounting.pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(mounting.roll, Eigen::Vector3d::UnitX());
}

}  // namespace

mcap::Bytes encode_rig(const Rig& rig) {
  v1::Rig message;
  for (const SensorDescription& sensor : rig.sensors) {
    v1::Sensor& part = *message.add_sensors();
    part.set_id(sensor.id);
    part.set_kind(static_cast<v1::SensorKind>(sensor.kind));
    part.set_name(sensor.name);
    lanefuse::put(sensor.mounting, *part.mutable_mounting());
    if (sensor.camera) put(*sensor.camera, *part.mutable_camera());
  }
  return to_bytes(message);
}

Rig decode_rig(std::span<const std::byte> bytes) {
  const auto message = parsed<v1::Rig>(bytes);
  check_count(message.sensors_size(), kMaxObjects, message.GetTypeName());
  Rig rig;
  for (const v1::Sensor& sensor : message.sensors()) {
    if (rig.find(sensor.id()))
      refuse(message.GetTypeName(), fmt::format("sensor {} stands twice", sensor.id()));
    rig.sensors.push_back(take(sensor));
  }
  return rig;
}

mcap::Bytes encode_transforms(const Rig& rig, Time time) {
  foxglove::FrameTransforms message;
  for (const SensorDescription& sensor : rig.sensors) {
    foxglove::FrameTransform& transform = *message.add_transforms();
    put(time, *transform.mutable_timestamp());
    transform.set_parent_frame_id(kVehicleFrame);
    transform.set_child_frame_id(sensor.name);
    transform.mutable_translation()->set_x(sensor.mounting.x);
    transform.mutable_translation()->set_y(sensor.mounting.y);
    transform.mutable_translation()->set_z(sensor.mounting.z);
    const Eigen::Quaterniond rotation = rotation_of(sensor.mounting);
    transform.mutable_rotation()->set_x(rotation.x());
    transform.mutable_rotation()->set_y(rotation.y());
    transform.mutable_rotation()->set_z(rotation.z());
    transform.mutable_rotation()->set_w(rotation.w());
  }
  return to_bytes(message);
}

}  // namespace lanefuse
