// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/map_command.hpp"

namespace lanefuse {
namespace {

void add_info(CLI::App& map, CommandLine& line) {
  auto& options = line.make<MapInfoOptions>();
  CLI::App& command = *map.add_subcommand("info", "say what a map holds: lanes, boundaries, origin");
  command.add_option("map", options.map, "the map (.xodr, .osm, .xml, .geojson)")->required();
  finish(command, line, options, map_info);
}

void add_convert(CLI::App& map, CommandLine& line) {
  auto& options = line.make<MapConvertOptions>();
  CLI::App& command = *map.add_subcommand("convert", "write a map in another format");
  command.add_option("map", options.map, "the map (.xodr, .osm, .xml, .geojson)")->required();
  command.add_option("-o,--output", options.output, "the map to write (.xodr, .osm, .geojson)")->required();
  command.add_option("--origin", options.origin, "where the map's origin is on Earth, LAT,LON [deg]");
  finish(command, line, options, map_convert);
}

}  // namespace

void add_map(CommandLine& line) {
  CLI::App& map = *line.app.add_subcommand("map", "maps of lanes: OpenDRIVE, Lanelet2, CommonRoad, GeoJSON");
  demand_subcommand(map);
  add_info(map, line);
  add_convert(map, line);
  add_survey(map, line);
}

}  // namespace lanefuse
