// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "sensors/measurement.hpp"

namespace lanefuse {

/// How many things a measurement holds: what the accounting counts.
std::uint64_t item_count(const Measurement& measurement);

/// What a measurement tells, as a number: messages of one sensor and one stamp are only the same if they tell
/// the same. A bus gives speed, wheel speeds and yaw rate in messages of their own.
std::size_t kind_of(const Measurement& measurement);

/// Order of a cycle's measurements, so that it does not matter in which order they came.
bool measured_before(const Measurement& a, const Measurement& b);

/// Cuts a measurement's list of objects or detections, or of features, to its bound and says how much went.
std::uint64_t cut_to_bounds(Measurement& measurement, std::size_t objects, std::size_t features);

}  // namespace lanefuse
