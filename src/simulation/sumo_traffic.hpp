// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "simulation/road.hpp"
#include "simulation/traffic_config.hpp"
#include "simulation/traffic_model.hpp"

namespace lanefuse {

/// Traffic by SUMO's sublane model, in which vehicles move across their lanes too. SUMO drives on a straight
/// road with our lanes, and places on it are places on ours: (station, lateral). Only one such traffic can
/// exist at a time, as SUMO is one for the whole process.
///
/// Throws a configuration error where the program was built without SUMO (CMake option LANEFUSE_SUMO), where
/// another one exists, and on a road whose lanes are not the same from end to end.
std::unique_ptr<TrafficModel> sumo_traffic(const Road& road, const TrafficConfig& config, double start,
                                           std::uint64_t seed);

}  // namespace lanefuse
