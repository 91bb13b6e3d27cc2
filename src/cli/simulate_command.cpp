// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/simulate_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "recording/drive_writer.hpp"
#include "roadmap/map_files.hpp"

namespace lanefuse {
namespace {

int list_scenarios(bool json) {
  auto list = nlohmann::ordered_json::array();
  for (const std::string& name : built_in_scenario_names()) {
    const Scenario scenario = built_in_scenario(name);
    list.push_back({{"name", name}, {"about", scenario.about}});
    if (!json) fmt::print("{:24} {}\n", name, scenario.about);
  }
  if (json) fmt::print("{}\n", nlohmann::ordered_json{{"scenarios", list}}.dump());
  return 0;
}

RoadKind road_kind(const std::string& word) {
  if (word == to_string(RoadKind::curved)) return RoadKind::curved;
  return word == to_string(RoadKind::sharp) ? RoadKind::sharp : RoadKind::gentle;
}

SimulationConfig configuration(const SimulateOptions& options) {
  SimulationConfig config = options.simulation;
  if (!options.scenario.empty()) config.scenario = find_scenario(options.scenario);
  Scenario::RoadPart& road = config.scenario.road;
  const bool has_a_road = road.course || road.map || (!options.map.empty() && !road.events.empty());
  if (has_a_road && !(options.road.empty() && options.map.empty())) {
    throw configuration_error(options.map.empty() ? "--road" : "--map",
                              fmt::format("scenario {} has a road of its own", config.scenario.name));
  }
  if (!options.road.empty() && !options.map.empty()) {
    throw configuration_error("--road", "is said of a road that comes from a map");
  }
  if (!options.map.empty()) road.map = options.map;
  config.road = road_kind(options.road);
  return config;
}

void check_outputs(const SimulateOptions& options) {
  if (options.output.empty()) throw configuration_error("simulate", "--output is required");
  check_output(options.output, options.force);
  if (options.write_map.empty()) return;
  check_map_ending(options.write_map);
  check_output(options.write_map, options.force);
}

struct Counts {
  std::uint64_t measurements = 0;
  Time end = kSimulationStart;
};

Counts record(DriveSimulation& simulation, DriveWriter& writer) {
  Progress progress("simulating");
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> frames;
  Counts counts;
  for (bool more = true; more;) {
    more = simulation.step(measurements, frames);
    for (const Measurement& measurement : measurements) writer.write(measurement);
    for (const TrueFrame& frame : frames) {
      writer.write(frame);
      counts.end = frame.time;
    }
    counts.measurements += measurements.size();
    progress.show(simulation.progress());
  }
  return counts;
}

}  // namespace

int simulate(const SimulateOptions& options) {
  if (options.list_scenarios) return list_scenarios(options.json);
  check_outputs(options);
  DriveSimulation simulation(configuration(options), nominal_preset());
  if (!options.write_map.empty()) write_map(simulation.map(), options.write_map);
  DriveWriter writer(options.output, simulation.info(), simulation.rig());
  writer.write(simulation.road(), kSimulationStart);
  const Counts counts = record(simulation, writer);
  writer.close();

  const double duration = to_seconds(counts.end - kSimulationStart);
  const DriveInfo info = simulation.info();
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"drive", info.name},
                                              {"output", options.output.string()},
                                              {"km", options.simulation.km},
                                              {"scenario", simulation.scenario().name},
                                              {"duration_s", duration},
                                              {"measurements", counts.measurements},
                                              {"preset_hash", info.preset_hash}}
                           .dump());
  } else {
    fmt::print("{}: {:.1f} s, {} measurements -> {}\n", info.name, duration, counts.measurements,
               options.output.string());
  }
  return 0;
}

}  // namespace lanefuse
