// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/osi_fields.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/osi_version.hpp"

namespace lanefuse {

using Classification = osi3::LaneBoundary::Classification;

void put_osi_version(osi3::InterfaceVersion& version) {
  version.set_version_major(kOsiMajor);
  version.set_version_minor(kOsiMinor);
  version.set_version_patch(kOsiPatch);
}

void put(Time time, osi3::Timestamp& message) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time.time_since_epoch());
  message.set_seconds(seconds.count());
  message.set_nanos(static_cast<std::uint32_t>((time.time_since_epoch() - seconds).count()));
}

void put(double x, double y, osi3::Vector3d& message) {
  message.set_x(x);
  message.set_y(y);
}

namespace {

Classification::Type osi_type(MarkingType type) {
  switch (type) {
    case MarkingType::unknown:
      return Classification::TYPE_UNKNOWN;
    case MarkingType::solid:
      return Classification::TYPE_SOLID_LINE;
    case MarkingType::dashed:
      return Classification::TYPE_DASHED_LINE;
    case MarkingType::road_edge:
      return Classification::TYPE_ROAD_EDGE;
    case MarkingType::guard_rail:
      return Classification::TYPE_GUARD_RAIL;
  }
  return Classification::TYPE_UNKNOWN;
}

Classification::Color osi_color(MarkingColour colour) {
  switch (colour) {
    case MarkingColour::unknown:
      return Classification::COLOR_UNKNOWN;
    case MarkingColour::white:
      return Classification::COLOR_WHITE;
    case MarkingColour::yellow:
      return Classification::COLOR_YELLOW;
  }
  return Classification::COLOR_UNKNOWN;
}

}  // namespace

void put(const MarkingEvidence& marking, Classification& message) {
  message.set_type(osi_type(marking.type));
  message.set_color(osi_color(marking.colour));
}

MarkingEvidence take(const Classification& message) {
  MarkingEvidence marking;
  for (const MarkingType type :
       {MarkingType::solid, MarkingType::dashed, MarkingType::road_edge, MarkingType::guard_rail}) {
    if (osi_type(type) == message.type()) marking.type = type;
  }
  for (const MarkingColour colour : {MarkingColour::white, MarkingColour::yellow}) {
    if (osi_color(colour) == message.color()) marking.colour = colour;
  }
  return marking;
}

std::uint64_t osi_identifier(std::int64_t id) {
  if (id < 0)
    throw input_error("osi3.Identifier", fmt::format("{} is below zero", id), "number from zero on");
  return static_cast<std::uint64_t>(id);
}

}  // namespace lanefuse
