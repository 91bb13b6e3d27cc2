// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/drive_road.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/generated_road.hpp"

namespace lanefuse {
namespace {

constexpr double kLeadIn = 400;   ///< [m] of road behind the start, for those who follow
constexpr double kLeadOut = 600;  ///< [m] of road beyond the end, for those ahead and for what sensors see
constexpr GeoOrigin kNearMunich{48.2, 11.6, 500};  ///< drawn roads have to lie somewhere

double checked_length(double km) {
  if (!(km > 0 && km <= 1000)) {
    throw configuration_error("simulation", fmt::format("{} km is no length of a drive", km),
                              "choose up to 1000 km");
  }
  return km * 1000;
}

}  // namespace

DriveRoad drive_road(const Scenario& scenario, RoadKind kind, double km, const RoadPreset& preset,
                     std::uint64_t seed) {
  const double length = checked_length(km);
  const RoadKind course = scenario.road.course.value_or(kind);
  const RoadPlan plan{course, kLeadIn + length + kLeadOut, kLeadIn, scenario.road.events};
  return {generated_road(plan, preset, seed), kLeadIn, to_string(course), kNearMunich};
}

}  // namespace lanefuse
