// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/motion_codec.hpp"

#include <cassert>

#include "lanefuse/measurements.pb.h"
#include "osi3/osi_hostvehicledata.pb.h"
#include "recording/message_bytes.hpp"
#include "recording/osi_fields.hpp"

namespace lanefuse {

mcap::Bytes encode_motion(const VehicleMotion& motion) {
  osi3::HostVehicleData message;
  put_osi_version(*message.mutable_version());
  put(motion.stamp.measured_at, *message.mutable_timestamp());
  auto& own = *message.mutable_vehicle_motion();
  if (motion.speed) own.mutable_velocity()->set_x(*motion.speed);
  if (motion.yaw_rate) own.mutable_orientation_rate()->set_yaw(*motion.yaw_rate);
  return to_bytes(message);
}

VehicleMotion decode_motion(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<osi3::HostVehicleData>(bytes);
  const auto& own = message.vehicle_motion();
  VehicleMotion motion{.stamp = stamp, .speed = {}, .yaw_rate = {}, .wheel_speeds = {}};
  if (own.velocity().has_x()) motion.speed = own.velocity().x();
  if (own.orientation_rate().has_yaw()) motion.yaw_rate = own.orientation_rate().yaw();
  return motion;
}

mcap::Bytes encode_wheel_speeds(const VehicleMotion& motion) {
  assert(motion.wheel_speeds);
  v1::WheelSpeeds message;
  message.set_front_left((*motion.wheel_speeds)[0]);
  message.set_front_right((*motion.wheel_speeds)[1]);
  message.set_rear_left((*motion.wheel_speeds)[2]);
  message.set_rear_right((*motion.wheel_speeds)[3]);
  return to_bytes(message);
}

VehicleMotion decode_wheel_speeds(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<v1::WheelSpeeds>(bytes);
  const std::array wheels{message.front_left(), message.front_right(), message.rear_left(),
                          message.rear_right()};
  return {.stamp = stamp, .speed = {}, .yaw_rate = {}, .wheel_speeds = wheels};
}

}  // namespace lanefuse
