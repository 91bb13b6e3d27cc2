// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/map_build_command.hpp"

#include <fmt/format.h>

#include "cli/map_comparison_text.hpp"
#include "cli/output_file.hpp"
#include "cli/progress.hpp"
#include "cli/survey_input.hpp"
#include "core/error.hpp"
#include "roadmap/map_files.hpp"
#include "roadmap/survey_map.hpp"

namespace lanefuse {
namespace {

std::vector<SurveyedDrive> read_drives(const std::vector<std::filesystem::path>& paths,
                                       const GeoOrigin& origin) {
  Progress progress("reading");
  std::vector<SurveyedDrive> drives;
  for (const std::filesystem::path& path : paths) {
    drives.push_back(read_surveyed(path, origin));
    progress.show(static_cast<double>(drives.size()) / static_cast<double>(paths.size()));
  }
  return drives;
}

void check_chart(const std::optional<std::filesystem::path>& chart, bool force, bool has_truth) {
  if (!chart) return;
  if (!has_truth)
    throw configuration_error("--chart", "there is nothing to compare with", "say --against, too");
  check_output(*chart, force);
}

void write_chart(const std::optional<std::filesystem::path>& chart, const MapComparison& comparison) {
  if (chart) write_text(*chart, to_chart(comparison));
}

}  // namespace

int map_build(const MapBuildOptions& options) {
  check_map_ending(options.output);
  for (const std::filesystem::path& drive : options.drives)
    check_output(options.output, options.force, drive);
  check_chart(options.chart, options.force, options.against.has_value());
  std::optional<RoadMap> truth;
  if (options.against) truth = read_map_or_exact(*options.against);
  const GeoOrigin origin = survey_origin(options.drives.front());
  const std::vector<SurveyedDrive> drives = read_drives(options.drives, origin);
  const RoadMap map = survey_map(drives, origin);
  write_map(map, options.output);

  std::optional<MapComparison> comparison;
  if (truth) {
    comparison = compare(map, *truth);
    write_chart(options.chart, *comparison);
  }
  if (options.json) {
    nlohmann::ordered_json json{{"output", options.output.string()},
                                {"drives", drives.size()},
                                {"boundaries", map.boundaries.size()},
                                {"lanes", map.lanes.size()}};
    if (comparison) json["deviation"] = to_json(*comparison);
    fmt::print("{}\n", json.dump());
  } else {
    const auto counted = [](std::size_t count, const char* what) {
      return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    fmt::print("{}: {} boundaries, {} -> {}\n", counted(drives.size(), "drive"), map.boundaries.size(),
               counted(map.lanes.size(), "lane"), options.output.string());
    if (comparison) fmt::print("{}", to_table(*comparison));
  }
  return 0;
}

int map_compare(const MapCompareOptions& options) {
  check_chart(options.chart, options.force, true);
  const MapComparison comparison = compare(read_map(options.map), read_map_or_exact(options.truth));
  write_chart(options.chart, comparison);
  fmt::print("{}", options.json ? to_json(comparison).dump() + "\n" : to_table(comparison));
  return 0;
}

}  // namespace lanefuse
