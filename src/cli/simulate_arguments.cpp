// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/simulate_command.hpp"

namespace lanefuse {

void add_simulate(CommandLine& line) {
  auto& options = line.make<SimulateOptions>();
  SimulationConfig& config = options.simulation;
  CLI::App& command =
      *line.app.add_subcommand("simulate", "simulate a drive on a motorway, with exact truth");
  command.add_option("--seed", config.seed, "the same seed gives the same bytes")
      ->capture_default_str()
      ->check(not_negative);
  command.add_option("--km", config.km, "length of the drive [km]")
      ->capture_default_str()
      ->check(CLI::Range(0.05, 1000.0));
  command
      .add_option("--road", options.road,
                  "curves of the road: gentle (radii 1.8-8 km), curved (0.6-5 km) or sharp (250-500 m)")
      ->check(CLI::IsMember({"gentle", "curved", "sharp"}))
      ->default_str("gentle");
  command
      .add_option("--scenario", options.scenario,
                  "what happens: a name from --list-scenarios, or a file (.yaml)")
      ->default_str("nominal");
  command.add_flag("--list-scenarios", options.list_scenarios, "print the scenarios' names, and stop");
  const auto leave_out = [&command](const std::string& flag, bool& sensor, const std::string& what) {
    command.add_flag_callback(
        flag, [&sensor] { sensor = false; }, "leave out the " + what);
  };
  leave_out("--no-serial-camera", config.serial_camera, "serial camera");
  leave_out("--no-high-resolution-camera", config.high_resolution_camera, "high-resolution camera");
  leave_out("--no-objects", config.objects, "object lists");
  command.add_option("-o,--output", options.output, "the recording to write (.mcap)");
  finish(command, line, options, simulate);
}

}  // namespace lanefuse
