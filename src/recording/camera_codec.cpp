// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/camera_codec.hpp"

#include "lanefuse/measurements.pb.h"
#include "recording/core_fields.hpp"

namespace lanefuse {
namespace {

void put(const ClothoidMeasurement& measurement, v1::ClothoidMeasurement& message) {
  lanefuse::put(measurement.clothoid, *message.mutable_clothoid());
  put_covariance<4>(measurement.covariance, *message.mutable_covariance());
  message.set_range_begin(measurement.range_begin);
  message.set_range_end(measurement.range_end);
  message.set_confidence(measurement.confidence);
  message.set_side(static_cast<v1::Side>(measurement.side));
  lanefuse::put(measurement.marking, *message.mutable_marking());
  if (measurement.marking_width) message.set_marking_width(*measurement.marking_width);
}

ClothoidMeasurement take(const v1::ClothoidMeasurement& message) {
  return {
      .clothoid = lanefuse::take(message.clothoid()),
      .covariance = take_covariance<4>(message.covariance(), message.GetTypeName()),
      .range_begin = message.range_begin(),
      .range_end = message.range_end(),
      .confidence = message.confidence(),
      .side = take_side(message.side()),
      .marking = lanefuse::take(message.marking()),
      .marking_width = message.has_marking_width() ? std::optional(message.marking_width()) : std::nullopt};
}

SharedError take(const v1::SharedError& message) {
  if (!v1::SharedError::Kind_IsValid(message.kind())) refuse(message.GetTypeName(), "its kind is unknown");
  return {static_cast<SharedError::Kind>(message.kind()), message.sigma()};
}

}  // namespace

mcap::Bytes encode_serial_lane(const SerialLane& lane) {
  v1::SerialLane message;
  if (lane.left) put(*lane.left, *message.mutable_left());
  if (lane.right) put(*lane.right, *message.mutable_right());
  if (lane.marking_width) message.set_marking_width(*lane.marking_width);
  return to_bytes(message);
}

SerialLane decode_serial_lane(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<v1::SerialLane>(bytes);
  SerialLane lane;
  lane.stamp = stamp;
  if (message.has_left()) lane.left = take(message.left());
  if (message.has_right()) lane.right = take(message.right());
  if (message.has_marking_width()) lane.marking_width = message.marking_width();
  return lane;
}

mcap::Bytes encode_marking_features(const MarkingFeatures& markings) {
  v1::MarkingFeatures message;
  for (const Feature& feature : markings.features) lanefuse::put(feature, *message.add_features());
  if (markings.shared_error) {
    auto& shared = *message.mutable_shared_error();
    shared.set_kind(static_cast<v1::SharedError::Kind>(markings.shared_error->kind));
    shared.set_sigma(markings.shared_error->sigma);
  }
  return to_bytes(message);
}

MarkingFeatures decode_marking_features(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<v1::MarkingFeatures>(bytes);
  check_count(message.features_size(), kMaxFeatures, message.GetTypeName());
  MarkingFeatures markings{.stamp = stamp, .features = {}, .shared_error = {}};
  for (const auto& feature : message.features()) markings.features.push_back(lanefuse::take(feature));
  if (message.has_shared_error()) markings.shared_error = take(message.shared_error());
  return markings;
}

}  // namespace lanefuse
