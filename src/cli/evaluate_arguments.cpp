// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/evaluate_command.hpp"

namespace lanefuse {

void add_evaluate(CommandLine& line) {
  auto& options = line.make<EvaluateOptions>();
  CLI::App& command =
      *line.app.add_subcommand("evaluate", "compare lanes with the truth, and write a report");
  command.add_option("lanes", options.lanes, "the estimated lanes (.mcap)")->required();
  CLI::Option* truth =
      command
          .add_option(
              "--truth", options.truth,
              "exact: the simulated road; surveyed: that road with the errors of the paper's own map; "
              "ego-path: where the car went later")
          ->check(CLI::IsMember({"exact", "surveyed", "ego-path"}));
  CLI::Option* map = command
                         .add_option("--map", options.map,
                                     "judge by this map instead, in the frame of the drive's true poses")
                         ->excludes(truth);
  command.add_option("--truth-seed", options.truth_seed, "seed of the survey's errors")
      ->capture_default_str()
      ->check(not_negative);
  const auto add_baseline = [&options](const std::string&) { options.serial_camera = true; };
  command
      .add_option_function<std::string>("--baseline", add_baseline,
                                        "judge a baseline beside the lanes: the serial camera alone")
      ->check(CLI::IsMember({"serial-camera"}));
  command.add_option("--drive", options.drive, "the drive with the truth, if it is not where run found it");
  command.add_option("-o,--report", options.report, "the report to write, else report.html beside the lanes");
  finish(command, line, options, evaluate);
  command.callback([&line, &options, truth, map] {
    if (truth->empty() && map->empty()) throw CLI::RequiredError("--truth or --map");
    if (options.serial_camera && options.truth == "ego-path") {
      throw CLI::ValidationError("--baseline", "needs the truth of a road, which --truth ego-path is not");
    }
    line.action = [&options] { return evaluate(options); };
  });
}

}  // namespace lanefuse
