// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "core/time.hpp"
#include "recording/mcap_records.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// One moment's truth as osi3.GroundTruth, in the world frame.
///
/// Other vehicles stand by OSI's rules, by the middle of their box and with their velocity as a vector; they
/// come back to within rounding (1e-9 of a metre and a metre a second for a road of 100 km). The host's place
/// is the origin of its vehicle frame, since a frame does not know the car's size; it carries the id
/// kHostVehicle, which no object has.
///
/// Both throw Error (input) for numbers that are not finite; writing throws for an id below zero.
mcap::Bytes encode_true_frame(const TrueFrame& frame);
TrueFrame decode_true_frame(std::span<const std::byte> bytes, Time time);

inline constexpr std::uint64_t kHostVehicle = std::uint64_t{1} << 63;

}  // namespace lanefuse
