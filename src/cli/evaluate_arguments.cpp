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
  command
      .add_option("--truth", options.truth,
                  "exact: the simulated road; surveyed: that road with the errors of the paper's own map; "
                  "ego-path: where the car went later")
      ->required()
      ->check(CLI::IsMember({"exact", "surveyed", "ego-path"}));
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
}

}  // namespace lanefuse
