// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "core/time.hpp"
#include "recording/mcap_records.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// The true road as one osi3.GroundTruth: boundaries with their points in the world frame and the paint's
/// width at each of them, lanes with their boundaries and neighbours. Read back exactly.
///
/// Both throw Error (input) for a boundary without points or a number that is not finite.
mcap::Bytes encode_true_road(const TrueRoad& road, Time time);
TrueRoad decode_true_road(std::span<const std::byte> bytes);

}  // namespace lanefuse
