// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/arguments.hpp"

#include <memory>

#include "cli/command_line.hpp"
#include "cli/plot_command.hpp"
#include "cli/run_command.hpp"
#include "cli/strip_command.hpp"

namespace lanefuse {
namespace {

constexpr const char* kDescription =
    "Lanefuse sees the lanes of a highway, the car's own and its neighbours', out to 120 m: from cameras,\n"
    "radars, the traffic around it, and its own motion.\n\n"
    "A first drive:\n"
    "  lanefuse simulate --seed 1 --km 2 -o drive.mcap\n"
    "  lanefuse run drive.mcap -o lanes.mcap\n"
    "  lanefuse evaluate lanes.mcap --truth exact";

void add_run(CommandLine& line) {
  auto& options = line.make<RunOptions>();
  CLI::App& command = *line.app.add_subcommand("run", "fuse a recorded drive to lanes");
  CLI::Option* drive = command.add_option("drive", options.drive, "the recorded drive (.mcap)");
  CLI::Option* output = command.add_option("-o,--output", options.output, "the lanes to write (.mcap)");
  command.add_option("--config", options.config, "YAML with settings that differ from the defaults");
  command
      .add_option("--estimator", options.estimator,
                  "what fuses, over file and --set: graph, the paper's, or road, the road-level one")
      ->check(CLI::IsMember({"graph", "road"}));
  command
      .add_option("--solver", options.solver,
                  "another solver for the graph, for comparison: direct, ceres, ceres:SETTING")
      ->capture_default_str();
  command.add_option("--dump-graphs", options.graph_folder,
                     "a folder for each cycle's graph before it is solved (000000.g2o, ...)");
  command.add_option("--set", options.assignments, "one setting, KEY=VALUE, over the file; may be repeated")
      ->expected(1)
      ->take_all();
  CLI::Option* print_config = command.add_flag("--print-config", options.print_config,
                                               "print every setting with effect, unit and range, and stop");
  finish(command, line, options, run);
  print_config->excludes("--json");
  command.callback([&line, &options, drive, output] {
    if (!options.print_config) {
      for (const CLI::Option* needed : {drive, output}) {
        if (needed->empty()) throw CLI::RequiredError(needed->get_name());
      }
    }
    line.action = [&options] { return run(options); };
  });
}

void add_plot(CommandLine& line) {
  auto& options = line.make<PlotOptions>();
  CLI::App& command = *line.app.add_subcommand("plot", "draw one moment from above, or all tracks over time");
  command.add_option("lanes", options.lanes, "the estimated lanes (.mcap)")->required();
  CLI::Option* at = command.add_option("--at", options.at, "seconds since the first cycle")
                        ->capture_default_str()
                        ->check(not_negative);
  CLI::Option* drive = command.add_option("--drive", options.drive,
                                          "the drive with the truth, if it is not where run found it");
  command.add_flag("--tracks", options.tracks, "draw the tracked vehicles of the whole drive over time")
      ->excludes(at)
      ->excludes(drive);
  command.add_option("-o,--output", options.output, "the picture to write (.svg)")->required();
  finish(command, line, options, plot);
}

void add_strip(CommandLine& line) {
  auto& options = line.make<StripOptions>();
  CLI::App& command = *line.app.add_subcommand("strip", "copy a recorded drive without its truth");
  command.add_option("drive", options.drive, "the recorded drive (.mcap)")->required();
  command.add_option("-o,--output", options.output, "the copy to write (.mcap)")->required();
  finish(command, line, options, strip);
}

}  // namespace

std::string not_negative(const std::string& text) {
  return text.rfind('-', 0) == 0 ? text + " is below 0" : "";
}

void demand_subcommand(CLI::App& app) {
  app.require_subcommand(0, 1);
  app.parse_complete_callback([&app] {
    if (app.get_subcommands().empty() && app.remaining().empty()) throw CLI::RequiredError::Subcommand(1);
  });
}

std::function<int()> parse_arguments(int argc, char** argv) {
  const auto line = std::shared_ptr<CommandLine>(new CommandLine{CLI::App(kDescription, "lanefuse"), {}, {}});
  demand_subcommand(line->app);
  line->app.set_version_flag("--version", "lanefuse " LANEFUSE_VERSION);
  add_simulate(*line);
  add_import(*line);
  add_run(*line);
  add_evaluate(*line);
  add_plot(*line);
  add_overlay(*line);
  add_strip(*line);
  add_graph(*line);
  add_benchmark(*line);
  add_bench(*line);
  add_map(*line);
  add_calibrate(*line);
  try {
    line->app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = line->app.exit(error) == 0 ? 0 : 2;
    return [code] { return code; };
  }
  return [line] { return line->action(); };
}

}  // namespace lanefuse
