// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/lane_estimate_codec.hpp"

#include <limits>

#include "lanefuse/lane_estimate.pb.h"
#include "recording/core_fields.hpp"

namespace lanefuse {
namespace {

void put(const Boundary& boundary, v1::Boundary& message) {
  message.set_id(boundary.id);
  lanefuse::put(boundary.clothoid, *message.mutable_clothoid());
  put_covariance<4>(boundary.covariance, *message.mutable_covariance());
  message.set_range_begin(boundary.range_begin);
  message.set_range_end(boundary.range_end);
  message.set_confidence(boundary.confidence);
  lanefuse::put(boundary.marking, *message.mutable_marking());
  for (const std::uint16_t count : boundary.support) message.add_support(count);
  for (const BoundaryPoint& point : boundary.points) {
    v1::BoundaryPoint& part = *message.add_points();
    part.set_x(point.x);
    part.set_y(point.y);
    part.set_sigma(point.sigma);
    part.set_protection(point.protection);
  }
}

void take_support(const v1::Boundary& message, Boundary& boundary) {
  if (message.support_size() > kSourceCount) refuse(message.GetTypeName(), "support by an unknown source");
  for (int i = 0; i < message.support_size(); ++i) {
    if (message.support(i) > std::numeric_limits<std::uint16_t>::max()) {
      refuse(message.GetTypeName(), "support by too many features");
    }
    boundary.support[i] = static_cast<std::uint16_t>(message.support(i));
  }
}

Boundary take(const v1::Boundary& message) {
  const std::string type = message.GetTypeName();
  Boundary boundary;
  boundary.id = message.id();
  boundary.clothoid = lanefuse::take(message.clothoid());
  boundary.covariance = take_covariance<4>(message.covariance(), type);
  boundary.range_begin = finite(message.range_begin(), type);
  boundary.range_end = finite(message.range_end(), type);
  boundary.confidence = finite(message.confidence(), type);
  boundary.marking = lanefuse::take(message.marking());
  take_support(message, boundary);
  for (const v1::BoundaryPoint& point : message.points()) {
    boundary.points.push_back({finite(point.x(), type), finite(point.y(), type), finite(point.sigma(), type),
                               finite(point.protection(), type)});
  }
  if (!boundary.clothoid.vector().allFinite() || !boundary.covariance.allFinite()) {
    refuse(type, "a number is not finite");
  }
  return boundary;
}

void put(const LanePoint& point, v1::LanePoint& message) {
  message.set_x(point.x);
  message.set_y(point.y);
  message.set_heading(point.heading);
  message.set_curvature(point.curvature);
  message.set_width(point.width);
  message.set_sigma(point.sigma);
  message.set_width_sigma(point.width_sigma);
}

void put(const Lane& lane, v1::Lane& message) {
  message.set_id(lane.id);
  message.set_left_boundary(lane.left_boundary);
  message.set_right_boundary(lane.right_boundary);
  if (lane.left_lane) message.set_left_lane(*lane.left_lane);
  if (lane.right_lane) message.set_right_lane(*lane.right_lane);
  message.set_range_begin(lane.range_begin);
  message.set_range_end(lane.range_end);
  message.set_confidence(lane.confidence);
  message.set_availability(lane.availability);
  for (const LanePoint& point : lane.centre) put(point, *message.add_centre());
}

LanePoint take(const v1::LanePoint& message, const std::string& type) {
  return {finite(message.x(), type),          finite(message.y(), type),     finite(message.heading(), type),
          finite(message.curvature(), type),  finite(message.width(), type), finite(message.sigma(), type),
          finite(message.width_sigma(), type)};
}

Lane take(const v1::Lane& message) {
  const std::string type = message.GetTypeName();
  Lane lane{message.id(), message.left_boundary(), message.right_boundary(), {}, {}};
  if (message.has_left_lane()) lane.left_lane = message.left_lane();
  if (message.has_right_lane()) lane.right_lane = message.right_lane();
  lane.range_begin = finite(message.range_begin(), type);
  lane.range_end = finite(message.range_end(), type);
  lane.confidence = finite(message.confidence(), type);
  lane.availability = finite(message.availability(), type);
  for (const v1::LanePoint& point : message.centre()) lane.centre.push_back(take(point, type));
  return lane;
}

void take_status(const v1::LaneEstimate& message, LaneEstimate& estimate) {
  const std::string type = message.GetTypeName();
  if (!v1::EstimateStatus_IsValid(message.status())) refuse(type, "its status is unknown");
  if (!v1::StatusReason_IsValid(message.reason())) refuse(type, "its reason is unknown");
  estimate.status = static_cast<EstimateStatus>(message.status());
  estimate.reason = static_cast<StatusReason>(message.reason());
  if (message.sources_size() > kSourceCount) refuse(type, "the status of an unknown source");
  estimate.sources.fill(SourceStatus::unavailable);
  for (int i = 0; i < message.sources_size(); ++i) {
    if (!v1::SourceStatus_IsValid(message.sources(i))) refuse(type, "a source's status is unknown");
    estimate.sources[i] = static_cast<SourceStatus>(message.sources(i));
  }
}

}  // namespace

mcap::Bytes encode_lane_estimate(const LaneEstimate& estimate) {
  v1::LaneEstimate message;
  message.set_status(static_cast<v1::EstimateStatus>(estimate.status));
  message.set_reason(static_cast<v1::StatusReason>(estimate.reason));
  message.set_speed(estimate.speed);
  message.set_yaw_rate(estimate.yaw_rate);
  message.set_witnesses(estimate.witnesses);
  for (const Boundary& boundary : estimate.boundaries) put(boundary, *message.add_boundaries());
  for (const Lane& lane : estimate.lanes) put(lane, *message.add_lanes());
  for (const SourceStatus status : estimate.sources)
    message.add_sources(static_cast<v1::SourceStatus>(status));
  message.mutable_inputs()->set_used(estimate.inputs.used);
  message.mutable_inputs()->set_rejected(estimate.inputs.rejected);
  message.mutable_inputs()->set_dropped(estimate.inputs.dropped);
  return to_bytes(message);
}

LaneEstimate decode_lane_estimate(std::span<const std::byte> bytes, Time time) {
  const auto message = parsed<v1::LaneEstimate>(bytes);
  check_count(message.boundaries_size() + message.lanes_size(), kMaxObjects, message.GetTypeName());
  LaneEstimate estimate;
  estimate.time = time;
  take_status(message, estimate);
  estimate.speed = finite(message.speed(), message.GetTypeName());
  estimate.yaw_rate = finite(message.yaw_rate(), message.GetTypeName());
  estimate.witnesses = message.witnesses();
  for (const v1::Boundary& boundary : message.boundaries()) estimate.boundaries.push_back(take(boundary));
  for (const v1::Lane& lane : message.lanes()) estimate.lanes.push_back(take(lane));
  estimate.inputs = {message.inputs().used(), message.inputs().rejected(), message.inputs().dropped()};
  return estimate;
}

}  // namespace lanefuse
