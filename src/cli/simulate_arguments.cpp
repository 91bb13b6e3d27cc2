// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/replay_command.hpp"
#include "cli/simulate_command.hpp"
#include "simulation/sensor_noise.hpp"

namespace lanefuse {
namespace {

void add_detections(CLI::App& command, SimulationConfig& config) {
  CLI::Option* detections =
      command.add_flag("--detections", config.detections,
                       "radars' reflections and a camera's boxes of vehicles, instead of object lists");
  command
      .add_option("--guard-rail-mirrors", config.guard_rail_mirrors,
                  "most vehicles that a radar sees mirrored in guard rails in a scan; else the preset's 2")
      ->check(CLI::Range(0, 50))
      ->needs(detections);
}

/// Options that say what is to be simulated have no meaning for a recording.
void add_replay(CLI::App& command, ReplayOptions& replay) {
  CLI::Option* file = command.add_option("--commonroad", replay.scenario,
                                         "replay the traffic recorded in a CommonRoad scenario (.xml)");
  for (const char* other :
       {"--km", "--road", "--scenario", "--map", "--write-map", "--list-scenarios", "--traffic", "--gnss-ins",
        "--road-seed", "--lane", "--ego-lane-changes", "--images", "--noise", "--no-serial-camera",
        "--no-high-resolution-camera", "--no-objects"}) {
    file->excludes(command.get_option(other));
  }
  command
      .add_option("--ego", replay.ego,
                  "the recorded vehicle that is the ego car, else the one recorded longest")
      ->needs(file);
  command.add_flag("--list", replay.list, "print which vehicles were recorded, and stop")->needs(file);
}

int simulate_or_replay(const SimulateOptions& options, ReplayOptions replay_options) {
  if (replay_options.scenario.empty()) return simulate(options);
  replay_options.seed = options.simulation.seed;
  replay_options.detections = options.simulation.detections;
  replay_options.guard_rail_mirrors = options.simulation.guard_rail_mirrors;
  replay_options.output = options.output;
  replay_options.json = options.json;
  replay_options.force = options.force;
  return replay(replay_options);
}

}  // namespace

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
  command.add_option("--map", options.map,
                     "drive on a map's road (.xodr, .osm, .xml of CommonRoad, .geojson)");
  command.add_option("--write-map", options.write_map,
                     "write the road as a map, too (.xodr, .osm, .geojson)");
  command.add_flag("--list-scenarios", options.list_scenarios, "print the scenarios' names, and stop");
  command
      .add_option_function<std::string>(
          "--traffic", [&config](const std::string& whose) { config.sumo = whose == "sumo"; },
          "whose drivers: built-in, or sumo if it is built in")
      ->check(CLI::IsMember({"built-in", "sumo"}))
      ->default_str("built-in");
  const auto leave_out = [&command](const std::string& flag, bool& sensor, const std::string& what) {
    command.add_flag_callback(
        flag, [&sensor] { sensor = false; }, "leave out the " + what);
  };
  command.add_flag("--gnss-ins", config.gnss_ins, "add RTK-GNSS/INS, for surveys and for maps");
  command.add_option("--road-seed", config.road_seed, "of the road alone, so that several drives share it")
      ->check(not_negative);
  command
      .add_option_function<int>(
          "--lane", [&config](int lane) { config.ego_lane = lane - 1; },
          "the lane to start in, from 1 on the left; else the middle one")
      ->check(CLI::Range(1, 20));
  command
      .add_option_function<std::string>(
          "--ego-lane-changes", [&config](const std::string& how) { config.ego_lane_changes = how == "on"; },
          "whether the car changes its lane")
      ->check(CLI::IsMember({"on", "off"}))
      ->default_str("on");
  command
      .add_option_function<std::string>(
          "--images", [&config](const std::string& word) { config.images = image_conditions(word); },
          "let the cameras hand over rendered images, under these conditions")
      ->check(CLI::IsMember({"clear", "low-sun", "wet", "night"}));
  command
      .add_option("--noise", config.noise,
                  "sensors err so many times as much as the preset, and they themselves, say")
      ->check(CLI::Range(kNoiseFactors.low, kNoiseFactors.high))
      ->excludes(command.get_option("--images"))
      ->capture_default_str();
  leave_out("--no-serial-camera", config.serial_camera, "serial camera");
  leave_out("--no-high-resolution-camera", config.high_resolution_camera, "high-resolution camera");
  leave_out("--no-objects", config.objects, "object lists, or what stands in for them");
  add_detections(command, config);
  command.add_option("-o,--output", options.output, "the recording to write (.mcap)");
  auto& replay = line.make<ReplayOptions>();
  add_replay(command, replay);
  finish(command, line, options,
         [&replay](const SimulateOptions& simulated) { return simulate_or_replay(simulated, replay); });
}

}  // namespace lanefuse
