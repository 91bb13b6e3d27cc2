// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace lanefuse {

/// Recorded time: 64-bit nanoseconds. Every measurement carries two of them, when it was measured and when it
/// was received; nothing inside the library reads a clock.
using Duration = std::chrono::nanoseconds;
using Time = std::chrono::time_point<std::chrono::system_clock, Duration>;

/// Seconds in a duration, for arithmetic with physical quantities.
constexpr double to_seconds(Duration duration) { return static_cast<double>(duration.count()) * 1e-9; }

/// The duration nearest to `seconds`; the caller guarantees |seconds| < 9e9.
constexpr Duration from_seconds(double seconds) {
  return Duration{static_cast<Duration::rep>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5))};
}

/// Nanoseconds since the epoch of the recording's clock.
constexpr std::int64_t to_nanoseconds(Time time) { return time.time_since_epoch().count(); }
constexpr Time from_nanoseconds(std::int64_t nanoseconds) { return Time{Duration{nanoseconds}}; }

}  // namespace lanefuse
