// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "roadmap/road_map.hpp"
#include "simulation/road.hpp"
#include "simulation/scenario.hpp"

namespace lanefuse {

/// The road of a simulated drive, and where on it the drive begins.
struct DriveRoad {
  Road road;
  double start = 0;  ///< [m] station of the drive's start
  std::string name;  ///< for people: "gentle", or the map's file
  std::optional<GeoOrigin> origin;
};

/// The road that the scenario says, else one of `kind`, long enough for a drive of `km`. Throws a
/// configuration error where the length is none, or longer than the scenario's map allows.
DriveRoad drive_road(const Scenario& scenario, RoadKind kind, double km, const RoadPreset& preset,
                     std::uint64_t seed);

}  // namespace lanefuse
