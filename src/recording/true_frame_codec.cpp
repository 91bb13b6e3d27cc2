// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/true_frame_codec.hpp"

#include <cmath>

#include "osi3/osi_groundtruth.pb.h"
#include "recording/message_bytes.hpp"
#include "recording/osi_fields.hpp"

namespace lanefuse {
namespace {

const std::string& type_name() { return osi3::GroundTruth::descriptor()->full_name(); }

/// A moving thing by its reference point and its speed along its heading.
void put_moving(const Pose2& pose, double speed, osi3::BaseMoving& base) {
  const double heading = finite(pose.heading, type_name());
  put(finite(pose.x, type_name()), finite(pose.y, type_name()), *base.mutable_position());
  base.mutable_orientation()->set_yaw(heading);
  finite(speed, type_name());
  put(speed * std::cos(heading), speed * std::sin(heading), *base.mutable_velocity());
}

Pose2 take_pose(const osi3::BaseMoving& base) {
  return {finite(base.position().x(), type_name()), finite(base.position().y(), type_name()),
          finite(base.orientation().yaw(), type_name())};
}

double take_speed(const osi3::BaseMoving& base) {
  const double heading = base.orientation().yaw();
  return finite(base.velocity().x() * std::cos(heading) + base.velocity().y() * std::sin(heading),
                type_name());
}

void put(const TrueObject& object, osi3::MovingObject& message) {
  message.mutable_id()->set_value(osi_identifier(object.id));
  message.set_type(osi3::MovingObject::TYPE_VEHICLE);
  osi3::BaseMoving& base = *message.mutable_base();
  put_moving(object.world_from_object * Pose2{object.length / 2, 0, 0}, object.speed, base);
  // The product wraps the heading, which the truth need not be.
  base.mutable_orientation()->set_yaw(object.world_from_object.heading);
  base.mutable_dimension()->set_length(finite(object.length, type_name()));
  base.mutable_dimension()->set_width(finite(object.width, type_name()));
}

TrueObject take(const osi3::MovingObject& message) {
  const osi3::BaseMoving& base = message.base();
  const double length = finite(base.dimension().length(), type_name());
  Pose2 rear = take_pose(base) * Pose2{-length / 2, 0, 0};
  rear.heading = base.orientation().yaw();
  return {.id = static_cast<std::int64_t>(message.id().value()),
          .world_from_object = rear,
          .speed = take_speed(base),
          .length = length,
          .width = finite(base.dimension().width(), type_name())};
}

void take_host(const osi3::BaseMoving& base, TrueFrame& frame) {
  frame.world_from_vehicle = take_pose(base);
  frame.speed = take_speed(base);
  frame.yaw_rate = finite(base.orientation_rate().yaw(), type_name());
}

}  // namespace

mcap::Bytes encode_true_frame(const TrueFrame& frame) {
  osi3::GroundTruth message;
  put_osi_version(*message.mutable_version());
  lanefuse::put(frame.time, *message.mutable_timestamp());
  message.mutable_host_vehicle_id()->set_value(kHostVehicle);
  osi3::MovingObject& host = *message.add_moving_object();
  host.mutable_id()->set_value(kHostVehicle);
  host.set_type(osi3::MovingObject::TYPE_VEHICLE);
  put_moving(frame.world_from_vehicle, frame.speed, *host.mutable_base());
  host.mutable_base()->mutable_orientation_rate()->set_yaw(finite(frame.yaw_rate, type_name()));
  for (const TrueObject& object : frame.objects) put(object, *message.add_moving_object());
  return to_bytes(message);
}

TrueFrame decode_true_frame(std::span<const std::byte> bytes, Time time) {
  const auto message = parsed<osi3::GroundTruth>(bytes);
  TrueFrame frame;
  frame.time = time;
  bool host_seen = false;
  for (const osi3::MovingObject& object : message.moving_object()) {
    if (object.id().value() != message.host_vehicle_id().value()) {
      frame.objects.push_back(take(object));
      continue;
    }
    take_host(object.base(), frame);
    host_seen = true;
  }
  if (!host_seen) refuse(type_name(), "the host vehicle is not among the moving objects");
  return frame;
}

}  // namespace lanefuse
