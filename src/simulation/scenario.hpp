// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/disturbance.hpp"
#include "simulation/road.hpp"
#include "simulation/road_event.hpp"
#include "simulation/traffic_config.hpp"

namespace lanefuse {

/// What makes a simulated drive, beyond its seed and its length: the road and what lies along it, the ego
/// car, the traffic, and what goes wrong with the sensors. What is not said is as in the preset. See
/// docs/scenarios.md.
struct Scenario {
  std::string name = "nominal";
  std::string about;  ///< one line for people

  struct RoadPart {
    std::optional<RoadKind> course;  ///< drawn with these curves; if not said, whoever simulates chooses
    std::optional<std::filesystem::path> map;  ///< or taken from a map file
    std::vector<RoadEvent> events;             ///< along a drawn road
  };
  struct EgoPart {
    std::optional<double> speed;              ///< [m/s]
    std::optional<double> lane_change_every;  ///< [s], may be TrafficConfig::kNever
    std::optional<StopAndGo> stop_and_go;
  };
  struct TrafficPart {
    std::optional<double> vehicles_per_metre_lane;  ///< [1/m]
    std::optional<double> trucks;                   ///< share
    std::optional<double> lane_change_every;        ///< [s] mean, a vehicle
    std::optional<double> jam_speed;                ///< [m/s]
    std::optional<double> lead_truck_gap;           ///< [m]
  };
  struct SensorsPart {
    bool serial_camera = true;
    bool high_resolution_camera = true;
    bool objects = true;
  };

  RoadPart road;
  EgoPart ego;
  TrafficPart traffic;
  SensorsPart sensors;
  std::vector<Disturbance> disturbances;  ///< in the order in which they befall a sensor's messages
};

/// How the scenario's traffic differs from the preset's.
TrafficConfig traffic_config(const Scenario& scenario, const SensorPreset& preset);

/// Names of the scenarios inside the program, in alphabetical order.
std::vector<std::string> built_in_scenario_names();
/// Throws a configuration error that lists the names where there is none of this name.
Scenario built_in_scenario(std::string_view name);
/// The file config/scenarios/NAME.yaml as it was when the program was built.
std::string_view built_in_scenario_text(std::string_view name);

/// Reads a scenario file; the scenario is named after the file, and a map's path in it counts from the file's
/// folder. Throws a configuration error that names the file, the line and the key which is unknown, missing,
/// of the wrong kind or out of range.
Scenario load_scenario(const std::filesystem::path& path);

/// A built-in scenario by its name, or one from a file: a path with a slash or an ending.
Scenario find_scenario(const std::string& name_or_file);

/// As load_scenario; `place` names the text in errors.
Scenario parse_scenario(std::string_view text, const std::string& place);

}  // namespace lanefuse
