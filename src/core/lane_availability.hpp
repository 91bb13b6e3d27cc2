// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/lane_estimate.hpp"
#include "core/time.hpp"

namespace lanefuse {

inline constexpr double kAvailabilityDistance = 60;  ///< [m] that a lane must reach
inline constexpr double kAvailabilitySpan = 10;      ///< [s] that are looked back

/// Remembers which lanes reached kAvailabilityDistance in the cycles of the last kAvailabilitySpan, by id:
/// the share of these cycles is a lane's availability. Until so much time has gone by, of the cycles there
/// were; a lane that was born later was not available before. Needs lanes that describe_lanes() has seen.
///
/// Its memory grows with the cycles and lanes of the span, then no more.
class LaneAvailability {
 public:
  /// Takes in a cycle, later than the last, and fills its lanes' availability.
  void update(LaneEstimate& estimate);
  void reset();

 private:
  /// A lane that was there in a cycle.
  struct Sighting {
    Time time{};
    std::uint64_t lane = 0;
  };
  std::vector<Time> cycles_;
  std::vector<Sighting> sightings_;
};

}  // namespace lanefuse
