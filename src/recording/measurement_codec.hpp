// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// A measurement as a message on its topic.
struct EncodedMeasurement {
  const char* topic = nullptr;
  mcap::Bytes bytes;
};

/// One message, or two for a motion that has wheel speeds beside speed or yaw rate.
std::vector<EncodedMeasurement> encode(const Measurement& measurement);

/// What turns messages of `topic` into measurements; null where they are none.
using MeasurementDecoder = Measurement (*)(std::span<const std::byte>, const Stamp&);
MeasurementDecoder decoder_of(std::string_view topic);

}  // namespace lanefuse
