// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/core_fields.hpp"

namespace lanefuse {

void put(const Clothoid& clothoid, v1::Clothoid& message) {
  message.set_lateral_offset(clothoid.lateral_offset);
  message.set_heading(clothoid.heading);
  message.set_curvature(clothoid.curvature);
  message.set_curvature_rate(clothoid.curvature_rate);
}

Clothoid take(const v1::Clothoid& message) {
  return {message.lateral_offset(), message.heading(), message.curvature(), message.curvature_rate()};
}

void put(const MarkingEvidence& marking, v1::Marking& message) {
  message.set_type(static_cast<v1::MarkingType>(marking.type));
  message.set_colour(static_cast<v1::MarkingColour>(marking.colour));
}

MarkingEvidence take(const v1::Marking& message) {
  if (!v1::MarkingType_IsValid(message.type())) refuse(message.GetTypeName(), "its type is unknown");
  if (!v1::MarkingColour_IsValid(message.colour())) refuse(message.GetTypeName(), "its colour is unknown");
  return {static_cast<MarkingType>(message.type()), static_cast<MarkingColour>(message.colour())};
}

Side take_side(v1::Side side) {
  if (!v1::Side_IsValid(side)) refuse("lanefuse.v1.Side", "the side is neither left nor right");
  return static_cast<Side>(side);
}

void put(const Feature& feature, v1::Feature& message) {
  message.set_x(feature.x);
  message.set_y(feature.y);
  message.set_heading(feature.heading);
  message.set_confidence(feature.confidence);
  put_covariance<3>(feature.covariance, *message.mutable_covariance());
  if (feature.track_id != kNoTrack) message.set_track_id(feature.track_id);
  message.set_source(static_cast<v1::Source>(feature.source));
  message.set_side(static_cast<v1::Side>(feature.side));
  put(feature.marking, *message.mutable_marking());
}

Feature take(const v1::Feature& message) {
  if (!v1::Source_IsValid(message.source())) refuse(message.GetTypeName(), "its source is unknown");
  return {.x = message.x(),
          .y = message.y(),
          .heading = message.heading(),
          .confidence = message.confidence(),
          .covariance = take_covariance<3>(message.covariance(), message.GetTypeName()),
          .track_id = message.has_track_id() ? message.track_id() : kNoTrack,
          .source = static_cast<Source>(message.source()),
          .side = take_side(message.side()),
          .marking = take(message.marking())};
}

}  // namespace lanefuse
