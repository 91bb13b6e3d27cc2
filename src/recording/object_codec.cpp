// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/object_codec.hpp"

#include <cmath>
#include <limits>

#include "osi3/osi_sensordata.pb.h"
#include "recording/core_fields.hpp"
#include "recording/osi_fields.hpp"

namespace lanefuse {
namespace {

using Detected = osi3::DetectedMovingObject;

Detected::MovementState osi_movement(MovementState state) {
  switch (state) {
    case MovementState::unknown:
      return Detected::MOVEMENT_STATE_UNKNOWN;
    case MovementState::stationary:
      return Detected::MOVEMENT_STATE_STATIONARY;
    case MovementState::moving:
      return Detected::MOVEMENT_STATE_MOVING;
    case MovementState::stopped:
      return Detected::MOVEMENT_STATE_STOPPED;
  }
  return Detected::MOVEMENT_STATE_UNKNOWN;
}

MovementState movement(Detected::MovementState state) {
  for (const auto known : {MovementState::stationary, MovementState::moving, MovementState::stopped}) {
    if (osi_movement(known) == state) return known;
  }
  return MovementState::unknown;
}

void put_box(const TrackedObject& object, Detected& message) {
  osi3::BaseMoving& base = *message.mutable_base();
  const double half = object.length / 2;
  put(object.x + half * std::cos(object.heading), object.y + half * std::sin(object.heading),
      *base.mutable_position());
  base.mutable_orientation()->set_yaw(object.heading);
  base.mutable_dimension()->set_length(object.length);
  base.mutable_dimension()->set_width(object.width);
  osi3::BaseMoving& rmse = *message.mutable_base_rmse();
  put(std::sqrt(object.covariance(0, 0)), std::sqrt(object.covariance(1, 1)), *rmse.mutable_position());
  rmse.mutable_orientation()->set_yaw(std::sqrt(object.covariance(2, 2)));
}

void put_rear(const TrackedObject& object, v1::RearState& message) {
  message.set_x(object.x);
  message.set_y(object.y);
  message.set_speed(object.speed);
  put_covariance<3>(object.covariance, *message.mutable_covariance());
  if (object.last_radar) message.set_last_radar(object.last_radar->time_since_epoch().count());
  if (object.last_camera) message.set_last_camera(object.last_camera->time_since_epoch().count());
  message.set_changing_lane(object.changing_lane);
  message.set_witness(object.witness);
}

std::optional<Time> time_of(bool known, std::int64_t nanoseconds) {
  if (!known) return {};
  return from_nanoseconds(nanoseconds);
}

void put(const TrackedObject& object, Detected& message) {
  message.mutable_header()->mutable_tracking_id()->set_value(osi_identifier(object.id));
  message.mutable_header()->set_existence_probability(object.existence);
  put_box(object, message);
  put_rear(object, *message.mutable_lanefuse_rear());
  message.set_reference_point(Detected::REFERENCE_POINT_REAR_MIDDLE);
  message.set_movement_state(osi_movement(object.movement));
  if (object.seen_by_radar) message.mutable_radar_specifics();
  if (object.seen_by_camera) message.mutable_camera_specifics();
}

TrackedObject take(const Detected& message) {
  const std::string& type = Detected::descriptor()->full_name();
  const std::uint64_t id = message.header().tracking_id().value();
  if (!message.has_lanefuse_rear()) refuse(type, "it has no lanefuse_rear");
  if (id > std::numeric_limits<std::int64_t>::max()) refuse(type, "its tracking_id is too large");
  const v1::RearState& rear = message.lanefuse_rear();
  return {.id = static_cast<std::int64_t>(id),
          .x = rear.x(),
          .y = rear.y(),
          .heading = message.base().orientation().yaw(),
          .speed = rear.speed(),
          .covariance = take_covariance<3>(rear.covariance(), type),
          .length = message.base().dimension().length(),
          .width = message.base().dimension().width(),
          .movement = movement(message.movement_state()),
          .existence = message.header().existence_probability(),
          .seen_by_radar = message.has_radar_specifics(),
          .seen_by_camera = message.has_camera_specifics(),
          .last_radar = time_of(rear.has_last_radar(), rear.last_radar()),
          .last_camera = time_of(rear.has_last_camera(), rear.last_camera()),
          .changing_lane = rear.changing_lane(),
          .witness = rear.witness()};
}

}  // namespace

mcap::Bytes encode_objects(const ObjectList& list) {
  osi3::SensorData message;
  put_osi_version(*message.mutable_version());
  lanefuse::put(list.stamp.measured_at, *message.mutable_timestamp());
  lanefuse::put(list.stamp.measured_at, *message.mutable_last_measurement_time());
  message.mutable_sensor_id()->set_value(list.stamp.sensor_id);
  for (const TrackedObject& object : list.objects) put(object, *message.add_moving_object());
  return to_bytes(message);
}

ObjectList decode_objects(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<osi3::SensorData>(bytes);
  check_count(message.moving_object_size(), kMaxObjects, message.GetTypeName());
  ObjectList list{.stamp = stamp, .objects = {}};
  for (const Detected& object : message.moving_object()) list.objects.push_back(take(object));
  return list;
}

}  // namespace lanefuse
