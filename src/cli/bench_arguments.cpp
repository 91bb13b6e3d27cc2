// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_command.hpp"
#include "cli/command_line.hpp"
#include "cli/endurance_command.hpp"

namespace lanefuse {
namespace {

void add_common(CLI::App& command, BenchOptions& options) {
  command.add_option("folder", options.folder, "the folder of .g2o files")->required();
  command.add_option("--solver", options.solver, "what is measured against Ceres")->capture_default_str();
}

void add_endurance(CLI::App& bench, CommandLine& line) {
  auto& options = line.make<EnduranceOptions>();
  CLI::App& command =
      *bench.add_subcommand("endurance", "a long simulated drive, fused in this process: times and memory");
  command.add_option("--hours", options.hours, "length of the drive [h]")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 36.0));
  command.add_option("--cycle-hz", options.cycle_hz, "cycles a second of the drive [Hz]")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 100.0));
  command.add_option("--report-minutes", options.report_minutes, "of the drive, between lines")
      ->capture_default_str()
      ->check(CLI::Range(0.05, 1440.0));
  command.add_option("--seed", options.seed, "of the drive")->capture_default_str();
  command.add_option("--scenario", options.scenario, "as in simulate")->capture_default_str();
  command.add_option("--estimator", options.estimator, "what fuses: graph or road")
      ->capture_default_str()
      ->check(CLI::IsMember({"graph", "road"}));
  command
      .add_option("--beside", options.beside,
                  "another solver that gets the same drive: direct, ceres, ceres:SETTING; may be repeated")
      ->expected(1)
      ->take_all();
  command.add_flag("--detections", options.detections, "raw detections instead of object lists");
  finish(command, line, options, bench_endurance);
}

}  // namespace

void add_bench(CommandLine& line) {
  CLI::App& bench = *line.app.add_subcommand("bench", "how fast graphs and whole cycles are, beside Ceres");
  demand_subcommand(bench);
  auto& graphs = line.make<BenchOptions>();
  CLI::App& lane_graphs =
      *bench.add_subcommand("lane-graphs", "each graph of a folder, warm-started, two iterations a cycle");
  add_common(lane_graphs, graphs);
  lane_graphs.add_option("--seconds", graphs.seconds, "how long a graph is repeated")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 3600.0));
  lane_graphs.add_flag("--sub-windows", graphs.sub_windows, "graphs with a share of the features, too");
  finish(lane_graphs, line, graphs, bench_lane_graphs);
  auto& windows = line.make<BenchOptions>();
  CLI::App& of_drive = *bench.add_subcommand("windows", "the windows that run --dump-graphs wrote");
  add_common(of_drive, windows);
  finish(of_drive, line, windows, bench_windows);
  add_endurance(bench, line);
}

}  // namespace lanefuse
