// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// A fix as foxglove.LocationFix, in degrees: latitude and longitude come back within a rounding of their
/// last bits, everything else exactly. Messages without heading, of other programs, are refused.
mcap::Bytes encode_gnss_ins(const GnssInsFix& fix);
GnssInsFix decode_gnss_ins(std::span<const std::byte> bytes, const Stamp& stamp);

}  // namespace lanefuse
