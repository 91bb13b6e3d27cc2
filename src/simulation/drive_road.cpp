// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/drive_road.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "roadmap/map_files.hpp"
#include "simulation/generated_road.hpp"
#include "simulation/road_from_map.hpp"

namespace lanefuse {
namespace {

constexpr double kLeadIn = 400;      ///< [m] of road behind the start, for those who follow
constexpr double kLeadOut = 600;     ///< [m] of road beyond the end, for those ahead and for what sensors see
constexpr double kMapLeadIn = 60;    ///< [m] of a map's road behind the start
constexpr double kMapLeadOut = 160;  ///< [m] of it beyond the end: as far as sensors see
constexpr double kShortestDrive = 50;              ///< [m]
constexpr GeoOrigin kNearMunich{48.2, 11.6, 500};  ///< drawn roads have to lie somewhere

double checked_length(double km) {
  if (!(km > 0 && km <= 4000)) {
    throw configuration_error("simulation", fmt::format("{} km is no length of a drive", km),
                              "choose up to 4000 km");
  }
  return km * 1000;
}

DriveRoad drive_road_from(const std::filesystem::path& file, double length, const RoadPreset& preset,
                          std::uint64_t seed) {
  const RoadMap map = read_map(file);
  Road road = road_from_map(map, preset, seed, file.string());
  const double available = road.length() - kMapLeadIn - kMapLeadOut;
  if (available < kShortestDrive) {
    throw input_error(file.string(),
                      fmt::format("{:.0f} m of road are too short for any drive", road.length()),
                      fmt::format("it takes {} m", kMapLeadIn + kMapLeadOut + kShortestDrive));
  }
  if (length > available) {
    throw configuration_error(
        file.string(),
        fmt::format("{:.0f} m of road are too short for a drive of {} km", road.length(), length / 1000),
        fmt::format("choose up to {:.2f} km", std::floor(available / 10) / 100));
  }
  return {std::move(road), kMapLeadIn, file.filename().string(), map.origin};
}

}  // namespace

DriveRoad drive_road(const Scenario& scenario, RoadKind kind, double km, const RoadPreset& preset,
                     std::uint64_t seed) {
  const double length = checked_length(km);
  if (scenario.road.map) return drive_road_from(*scenario.road.map, length, preset, seed);
  const RoadKind course = scenario.road.course.value_or(kind);
  const RoadPlan plan{course, kLeadIn + length + kLeadOut, kLeadIn, scenario.road.events};
  return {generated_road(plan, preset, seed), kLeadIn, to_string(course), kNearMunich};
}

}  // namespace lanefuse
