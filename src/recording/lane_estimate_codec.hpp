// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "core/lane_estimate.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse {

/// All of an estimate but its time, as lanefuse.v1.LaneEstimate. Reading throws Error (input) where a
/// boundary's numbers are not finite.
mcap::Bytes encode_lane_estimate(const LaneEstimate& estimate);
LaneEstimate decode_lane_estimate(std::span<const std::byte> bytes, Time time);

}  // namespace lanefuse
