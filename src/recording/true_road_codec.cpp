// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/true_road_codec.hpp"

#include <optional>
#include <string>

#include "osi3/osi_groundtruth.pb.h"
#include "recording/message_bytes.hpp"
#include "recording/osi_fields.hpp"

namespace lanefuse {
namespace {

using Identifiers = google::protobuf::RepeatedPtrField<osi3::Identifier>;

void put(const TrueBoundary& boundary, osi3::LaneBoundary& message) {
  const std::string& type = message.GetDescriptor()->full_name();
  if (boundary.points.empty()) refuse(type, "a true boundary without points");
  message.mutable_id()->set_value(boundary.id);
  lanefuse::put(boundary.marking, *message.mutable_classification());
  for (const Eigen::Vector2d& point : boundary.points) {
    auto& part = *message.add_boundary_line();
    lanefuse::put(finite(point.x(), type), finite(point.y(), type), *part.mutable_position());
    part.set_width(finite(boundary.marking_width, type));
  }
}

TrueBoundary take(const osi3::LaneBoundary& message) {
  const std::string& type = message.GetDescriptor()->full_name();
  if (message.boundary_line_size() == 0) refuse(type, "a true boundary without points");
  TrueBoundary boundary;
  boundary.id = message.id().value();
  boundary.marking = lanefuse::take(message.classification());
  boundary.marking_width = finite(message.boundary_line(0).width(), type);
  for (const auto& part : message.boundary_line()) {
    boundary.points.emplace_back(finite(part.position().x(), type), finite(part.position().y(), type));
  }
  return boundary;
}

void put(const TrueLane& lane, osi3::Lane& message) {
  message.mutable_id()->set_value(lane.id);
  auto& classification = *message.mutable_classification();
  classification.set_type(osi3::Lane::Classification::TYPE_DRIVING);
  classification.add_left_lane_boundary_id()->set_value(lane.left_boundary);
  classification.add_right_lane_boundary_id()->set_value(lane.right_boundary);
  if (lane.left_lane) classification.add_left_adjacent_lane_id()->set_value(*lane.left_lane);
  if (lane.right_lane) classification.add_right_adjacent_lane_id()->set_value(*lane.right_lane);
}

std::uint64_t only(const Identifiers& identifiers) {
  if (identifiers.size() != 1) refuse("osi3.Lane", "a lane needs one boundary on each side");
  return identifiers[0].value();
}

std::optional<std::uint64_t> neighbour(const Identifiers& identifiers) {
  if (identifiers.empty()) return {};
  return identifiers[0].value();
}

TrueLane take(const osi3::Lane& message) {
  const auto& classification = message.classification();
  return {.id = message.id().value(),
          .left_boundary = only(classification.left_lane_boundary_id()),
          .right_boundary = only(classification.right_lane_boundary_id()),
          .left_lane = neighbour(classification.left_adjacent_lane_id()),
          .right_lane = neighbour(classification.right_adjacent_lane_id())};
}

}  // namespace

mcap::Bytes encode_true_road(const TrueRoad& road, Time time) {
  osi3::GroundTruth message;
  put_osi_version(*message.mutable_version());
  lanefuse::put(time, *message.mutable_timestamp());
  for (const TrueBoundary& boundary : road.boundaries) put(boundary, *message.add_lane_boundary());
  for (const TrueLane& lane : road.lanes) put(lane, *message.add_lane());
  return to_bytes(message);
}

TrueRoad decode_true_road(std::span<const std::byte> bytes) {
  const auto message = parsed<osi3::GroundTruth>(bytes);
  TrueRoad road;
  for (const osi3::LaneBoundary& boundary : message.lane_boundary())
    road.boundaries.push_back(take(boundary));
  for (const osi3::Lane& lane : message.lane()) road.lanes.push_back(take(lane));
  return road;
}

}  // namespace lanefuse
