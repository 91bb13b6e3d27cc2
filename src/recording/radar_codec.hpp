// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// One radar's reflections as lanefuse.v1.RadarScan. Numbers that are not finite pass: their source rejects
/// them.
mcap::Bytes encode_radar_scan(const RadarScan& scan);
RadarScan decode_radar_scan(std::span<const std::byte> bytes, const Stamp& stamp);

}  // namespace lanefuse
