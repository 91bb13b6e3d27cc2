// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "simulation/road.hpp"
#include "simulation/traffic_config.hpp"

namespace lanefuse {

inline constexpr const char* kSumoEgo = "0";

/// The road, straightened, as a SUMO network of one edge: x is the station, y the lateral place.
/// Throws a configuration error where a lane begins, ends or moves.
std::string sumo_network(const Road& road);

/// SUMO's vehicles at the density that the configuration wants: the ego car at `start` [m] in the middle
/// lane, the others all along the road, and more of them that follow.
std::string sumo_vehicles(const Road& road, const TrafficConfig& config, double start, std::uint64_t seed);

}  // namespace lanefuse
