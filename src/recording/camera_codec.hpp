// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// What cameras hand over, as lanefuse.v1.SerialLane and lanefuse.v1.MarkingFeatures. Covariances travel as
/// their upper triangles. Numbers that are not finite pass: the sources reject and count them one by one.

mcap::Bytes encode_serial_lane(const SerialLane& lane);
SerialLane decode_serial_lane(std::span<const std::byte> bytes, const Stamp& stamp);

mcap::Bytes encode_marking_features(const MarkingFeatures& markings);
MarkingFeatures decode_marking_features(std::span<const std::byte> bytes, const Stamp& stamp);

}  // namespace lanefuse
