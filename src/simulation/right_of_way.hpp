// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/traffic_lanes.hpp"
#include "simulation/vehicle.hpp"

namespace lanefuse {

/// What the flow of the traffic does to a driver, beyond the vehicles that are there.
struct FlowAhead {
  double speed_limit = 0;  ///< [m/s]
  double gap = 0;          ///< [m] to the next vehicle for those who see none; infinite on a free road
};

/// The acceleration [m/s^2] at which the vehicle keeps its distance from everyone ahead in the lanes that it
/// fills, stops before its lane ends, and gives way where lanes merge: those who must leave a lane and those
/// beside them take turns.
double acceleration_among(const Vehicle& vehicle, const std::vector<Vehicle>& all, const TrafficLanes& lanes,
                          const FlowAhead& flow);

/// Whether the vehicle can change to the lane without anyone having to brake hard, or to get too close.
bool is_free_for(const Vehicle& vehicle, int lane, const std::vector<Vehicle>& all);

/// Whether `follower` can drive on behind `leader` without braking hard.
bool in_safe_order(const Vehicle& follower, const Vehicle& leader);

}  // namespace lanefuse
