// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/map_build_command.hpp"
#include "cli/map_localize_command.hpp"

namespace lanefuse {
namespace {

constexpr const char* kChart = "a picture of the deviation along the road to write (.svg)";

void add_build(CLI::App& map, CommandLine& line) {
  auto& options = line.make<MapBuildOptions>();
  CLI::App& command =
      *map.add_subcommand("build", "survey a road: merge drives with GNSS/INS, each on a lane, into a map");
  command.add_option("drives", options.drives, "recorded drives (.mcap)")->required();
  command.add_option("-o,--output", options.output, "the map to write (.xodr, .osm, .geojson)")->required();
  command.add_option("--against", options.against, "compare with this drive's exact road, or with this map");
  command.add_option("--chart", options.chart, kChart);
  finish(command, line, options, map_build);
}

void add_compare(CLI::App& map, CommandLine& line) {
  auto& options = line.make<MapCompareOptions>();
  CLI::App& command = *map.add_subcommand("compare", "say how far a map's lines lie from the true ones");
  command.add_option("map", options.map, "the map (.xodr, .osm, .xml, .geojson)")->required();
  command.add_option("--truth", options.truth, "another map, or a drive with its exact road (.mcap)")
      ->required();
  command.add_option("--chart", options.chart, kChart);
  finish(command, line, options, map_compare);
}

void add_localize(CLI::App& map, CommandLine& line) {
  auto& options = line.make<MapLocalizeOptions>();
  CLI::App& command =
      *map.add_subcommand("localize", "place a drive in a map, by its GNSS/INS and by the markings it saw");
  command.add_option("drive", options.drive, "the recorded drive (.mcap)")->required();
  command.add_option("--map", options.map, "the map (.xodr, .osm, .geojson), with its origin on Earth")
      ->required();
  command.add_option("-o,--output", options.output, "the poses to write, one a line (.csv)");
  finish(command, line, options, map_localize);
}

}  // namespace

void add_survey(CLI::App& map, CommandLine& line) {
  add_build(map, line);
  add_compare(map, line);
  add_localize(map, line);
}

}  // namespace lanefuse
