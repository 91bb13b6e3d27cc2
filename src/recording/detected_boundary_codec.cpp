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

}  // namespace

mcap::Bytes encode_detected_boundaries(const LaneEstimate& estimate) {
  osi3::SensorData message;
  put_osi_version(*message.mutable_version());
  lanefuse::put(estimate.time, *message.mutable_timestamp());
  lanefuse::put(estimate.time, *message.mutable_last_measurement_time());
  for (const Boundary& boundary : estimate.boundaries) put(boundary, *message.add_lane_boundary());
  return to_bytes(message);
}

}  // namespace lanefuse
