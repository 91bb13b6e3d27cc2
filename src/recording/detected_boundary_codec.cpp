// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "osi3/osi_sensordata.pb.h"
#include "recording/message_bytes.hpp"
#include "recording/osi_fields.hpp"
#include "recording/viewer_codec.hpp"

namespace lanefuse {
namespace {

void put(const Boundary& boundary, osi3::DetectedLaneBoundary& message) {
  message.mutable_header()->mutable_tracking_id()->set_value(boundary.id);
  message.mutable_header()->set_existence_probability(boundary.confidence);
  auto& candidate = *message.add_candidate();
  candidate.set_probability(1);
  lanefuse::put(boundary.marking, *candidate.mutable_classification());
  for (const BoundaryPoint& point : boundary.points) {
    lanefuse::put(point.x, point.y, *message.add_boundary_line()->mutable_position());
    lanefuse::put(0, point.sigma, *message.add_boundary_line_rmse()->mutable_position());
    message.add_boundary_line_confidences(boundary.confidence);
  }
}

void put(const Lane& lane, bool is_ego, osi3::DetectedLane& message) {
  message.mutable_header()->mutable_tracking_id()->set_value(lane.id);
  message.mutable_header()->set_existence_probability(lane.confidence);
  auto& candidate = *message.add_candidate();
  candidate.set_probability(1);
  auto& kind = *candidate.mutable_classification();
  kind.set_type(osi3::Lane::Classification::TYPE_DRIVING);
  kind.set_is_host_vehicle_lane(is_ego);
  kind.set_centerline_is_driving_direction(true);
  for (const LanePoint& point : lane.centre) lanefuse::put(point.x, point.y, *kind.add_centerline());
  if (lane.left_lane) kind.add_left_adjacent_lane_id()->set_value(*lane.left_lane);
  if (lane.right_lane) kind.add_right_adjacent_lane_id()->set_value(*lane.right_lane);
  kind.add_left_lane_boundary_id()->set_value(lane.left_boundary);
  kind.add_right_lane_boundary_id()->set_value(lane.right_boundary);
}

}  // namespace

mcap::Bytes encode_detected_boundaries(const LaneEstimate& estimate) {
  osi3::SensorData message;
  put_osi_version(*message.mutable_version());
  lanefuse::put(estimate.time, *message.mutable_timestamp());
  lanefuse::put(estimate.time, *message.mutable_last_measurement_time());
  for (const Boundary& boundary : estimate.boundaries) put(boundary, *message.add_lane_boundary());
  const Lane* ego = ego_lane(estimate);
  for (const Lane& lane : estimate.lanes) put(lane, &lane == ego, *message.add_lane());
  return to_bytes(message);
}

}  // namespace lanefuse
