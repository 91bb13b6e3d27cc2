// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/simulate_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "cli/progress.hpp"
#include "recording/drive_writer.hpp"

namespace lanefuse {

int simulate(const SimulateOptions& options) {
  check_output(options.output, options.force);
  DriveSimulation simulation(options.simulation, nominal_preset());
  DriveWriter writer(options.output, simulation.info(), simulation.rig());
  writer.write(simulation.road(), kSimulationStart);

  Progress progress("simulating");
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> frames;
  std::uint64_t measurement_count = 0;
  Time end = kSimulationStart;
  for (bool more = true; more;) {
    more = simulation.step(measurements, frames);
    for (const Measurement& measurement : measurements) writer.write(measurement);
    for (const TrueFrame& frame : frames) {
      writer.write(frame);
      end = frame.time;
    }
    measurement_count += measurements.size();
    progress.show(simulation.progress());
  }
  writer.close();

  const double duration = to_seconds(end - kSimulationStart);
  const DriveInfo info = simulation.info();
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"drive", info.name},
                                              {"output", options.output.string()},
                                              {"km", options.simulation.km},
                                              {"duration_s", duration},
                                              {"measurements", measurement_count},
                                              {"preset_hash", info.preset_hash}}
                           .dump());
  } else {
    fmt::print("{}: {:.1f} s, {} measurements -> {}\n", info.name, duration, measurement_count,
               options.output.string());
  }
  return 0;
}

}  // namespace lanefuse
