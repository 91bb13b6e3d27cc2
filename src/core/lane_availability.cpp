// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/lane_availability.hpp"

#include <algorithm>

namespace lanefuse {

void LaneAvailability::update(LaneEstimate& estimate) {
  const Time horizon = estimate.time - from_seconds(kAvailabilitySpan);
  std::erase_if(cycles_, [horizon](Time time) { return time <= horizon; });
  std::erase_if(sightings_, [horizon](const Sighting& sighting) { return sighting.time <= horizon; });
  cycles_.push_back(estimate.time);
  for (Lane& lane : estimate.lanes) {
    if (lane.range_end >= kAvailabilityDistance) sightings_.push_back({estimate.time, lane.id});
    const auto seen = std::count_if(sightings_.begin(), sightings_.end(),
                                    [&lane](const Sighting& sighting) { return sighting.lane == lane.id; });
    lane.availability = static_cast<double>(seen) / static_cast<double>(cycles_.size());
  }
}

void LaneAvailability::reset() {
  cycles_.clear();
  sightings_.clear();
}

}  // namespace lanefuse
