// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/replay_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "recording/drive_writer.hpp"
#include "simulation/replay_simulation.hpp"

namespace lanefuse {
namespace {

CommonRoadScenario read_traffic(const std::filesystem::path& path) {
  CommonRoadScenario scenario = read_commonroad(path);
  if (scenario.vehicles.empty()) {
    throw input_error(path.string(), "holds no recorded vehicle", "choose a scenario with trajectories");
  }
  return scenario;
}

int list_vehicles(const CommonRoadScenario& scenario, bool json) {
  auto list = nlohmann::ordered_json::array();
  for (const RecordedVehicle& vehicle : scenario.vehicles) {
    const RecordedMotion motion(vehicle, 0);
    const double way = motion.at(motion.end()).way - motion.at(motion.begin()).way;
    const double seconds = motion.end() - motion.begin();
    list.push_back({{"id", vehicle.id},
                    {"kind", to_string(vehicle.kind)},
                    {"length_m", vehicle.length},
                    {"from_s", motion.begin()},
                    {"duration_s", seconds},
                    {"way_m", way}});
    if (!json) {
      fmt::print("{:8} {:10} {:5.1f} m long, from {:5.1f} s for {:5.1f} s, {:6.1f} m\n", vehicle.id,
                 to_string(vehicle.kind), vehicle.length, motion.begin(), seconds, way);
    }
  }
  if (json) fmt::print("{}\n", nlohmann::ordered_json{{"vehicles", list}}.dump());
  return 0;
}

struct Written {
  double seconds = 0;
  std::uint64_t measurements = 0;
};

Written record(ReplaySimulation& simulation, DriveWriter& writer) {
  Progress progress("replaying");
  Written written;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> frames;
  for (bool more = true; more;) {
    more = simulation.step(measurements, frames);
    for (const Measurement& measurement : measurements) writer.write(measurement);
    for (const TrueFrame& frame : frames) {
      writer.write(frame);
      written.seconds = to_seconds(frame.time - kSimulationStart);
    }
    written.measurements += measurements.size();
    progress.show(simulation.progress());
  }
  return written;
}

}  // namespace

int replay(const ReplayOptions& options) {
  const CommonRoadScenario scenario = read_traffic(options.scenario);
  if (options.list) return list_vehicles(scenario, options.json);
  if (options.output.empty()) throw configuration_error("simulate", "--output is required");
  check_output(options.output, options.force);
  const std::int64_t ego = options.ego ? *options.ego : longest_stay(scenario.vehicles).id;
  const SensorPreset preset = nominal_preset();
  const ReplayConfig config{options.scenario.filename().string(), ego, options.seed, options.detections,
                            options.guard_rail_mirrors};
  ReplaySimulation simulation(scenario, config, preset);
  DriveWriter writer(options.output, simulation.info(), simulation.rig());
  writer.write(simulation.road(), kSimulationStart);
  const Written written = record(simulation, writer);
  writer.close();

  const DriveInfo& info = simulation.info();
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"drive", info.name},
                                              {"output", options.output.string()},
                                              {"ego", ego},
                                              {"duration_s", written.seconds},
                                              {"measurements", written.measurements},
                                              {"preset_hash", info.preset_hash}}
                           .dump());
  } else {
    fmt::print("{}: {:.1f} s, {} measurements -> {}\n", info.name, written.seconds, written.measurements,
               options.output.string());
  }
  return 0;
}

}  // namespace lanefuse
