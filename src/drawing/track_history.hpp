// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "sensors/measurement.hpp"

namespace lanefuse {

/// How a track stood at one moment: it bore witness, drove without doing so, or stood.
enum class TrackRole : std::uint8_t { witness = 0, driving = 1, standing = 2 };

struct TrackMoment {
  double seconds = 0;
  double ahead = 0;  ///< [m] of the car's origin, to the middle of the rear
  double left = 0;   ///< [m]
  TrackRole role = TrackRole::driving;
};

/// All moments of one id, in order of time.
struct TrackedLife {
  std::int64_t id = 0;
  std::vector<TrackMoment> moments;  ///< not empty

  [[nodiscard]] double kept() const { return moments.back().seconds - moments.front().seconds; }  ///< [s]
  [[nodiscard]] bool was(TrackRole role) const;
};

/// Gathers a drive's tracks cycle by cycle, for a picture of all of them.
class TrackHistory {
 public:
  /// One cycle; `seconds` do not decrease. What has no finite place is left out.
  void add(double seconds, std::span<const TrackedObject> objects);

  /// In order of their first moments, and of ids where these are the same.
  [[nodiscard]] std::vector<TrackedLife> lives() const;
  [[nodiscard]] double duration() const { return duration_; }  ///< [s] of the last cycle

 private:
  std::map<std::int64_t, TrackedLife> lives_;
  double duration_ = 0;
};

}  // namespace lanefuse
