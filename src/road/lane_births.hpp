// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "road/road_state.hpp"
#include "road/vehicle_update.hpp"

namespace lanefuse {

/// Where vehicles drive for a while and no lane is known, there is one: its lines are founded beside them, as
/// far apart as lanes are, next to what is known. Paint that is seen later says better where they are.
class LaneBirths {
 public:
  void clear() { candidates_.clear(); }

  /// Vehicles of one look that are in no known lane.
  void gather(std::span<const VehicleUpdate::Sighting> strays, const RoadState& state);
  /// The car moved aside by `aside` [m], and `seconds` went by.
  void move(double aside, double seconds);
  void found_lanes(const LaneWidth& width, RoadState& state);

 private:
  struct Candidate {
    double lateral = 0;  ///< [m] of its middle, left of the axis
    double weight = 0;   ///< sightings of late
  };
  static void found_lane(double middle, const LaneWidth& width, RoadState& state);

  std::vector<Candidate> candidates_;
};

}  // namespace lanefuse
