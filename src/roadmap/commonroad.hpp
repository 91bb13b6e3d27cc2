// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "roadmap/road_map.hpp"

namespace lanefuse {

enum class RecordedKind : std::uint8_t { car = 0, truck = 1, bus = 2, motorcycle = 3, other = 4 };
const char* to_string(RecordedKind kind);

/// Where a recorded vehicle was at one moment, in the map's frame.
struct RecordedState {
  double time_s = 0;   ///< [s] since the scenario's beginning
  double x = 0;        ///< [m] middle of the box
  double y = 0;        ///< [m]
  double heading = 0;  ///< [rad] in [-pi, pi)
  double speed = 0;    ///< [m/s]
};

struct RecordedVehicle {
  std::int64_t id = 0;
  RecordedKind kind = RecordedKind::car;
  double length = 4.5;                ///< [m]
  double width = 1.8;                 ///< [m]
  std::vector<RecordedState> states;  ///< in order of time, at least one
};

/// A CommonRoad scenario: its lanes, and the traffic that was recorded on them.
struct CommonRoadScenario {
  RoadMap map;
  double time_step = 0.1;  ///< [s]
  std::vector<RecordedVehicle> vehicles;
};

/// Reads CommonRoad XML, 2018b and 2020a. Neighbours' common bounds become one boundary, and lanelets that
/// follow one another become long lanes. Static obstacles are left out, as is traffic that is known only by
/// the area which it may occupy. Throws an input error that names line and element.
CommonRoadScenario read_commonroad(const std::filesystem::path& path);

}  // namespace lanefuse
