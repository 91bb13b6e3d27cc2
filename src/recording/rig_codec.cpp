// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/rig_codec.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "foxglove/frame_transforms.pb.h"
#include "lanefuse/rig.pb.h"
#include "recording/foxglove_fields.hpp"
#include "recording/message_bytes.hpp"

namespace lanefuse {
namespace {

void put(const Mounting& mounting, v1::Mounting& message) {
  message.set_x(mounting.x);
  message.set_y(mounting.y);
  message.set_z(mounting.z);
  message.set_roll(mounting.roll);
  message.set_pitch(mounting.pitch);
  message.set_yaw(mounting.yaw);
}

Mounting take(const v1::Mounting& message) {
  for (const double number :
       {message.x(), message.y(), message.z(), message.roll(), message.pitch(), message.yaw()}) {
    finite(number, message.GetTypeName());
  }
  return {message.x(), message.y(), message.z(), message.roll(), message.pitch(), message.yaw()};
}

SensorDescription take(const v1::Sensor& message) {
  if (!v1::SensorKind_IsValid(message.kind())) refuse(message.GetTypeName(), "its kind is unknown");
  return {message.id(), static_cast<SensorKind>(message.kind()), message.name(), take(message.mounting())};
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
    put(sensor.mounting, *part.mutable_mounting());
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
