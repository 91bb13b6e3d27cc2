// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_command.hpp"
#include "cli/command_line.hpp"

namespace lanefuse {
namespace {

void add_common(CLI::App& command, BenchOptions& options) {
  command.add_option("folder", options.folder, "the folder of .g2o files")->required();
  command.add_option("--solver", options.solver, "what is measured against Ceres")->capture_default_str();
}

}  // namespace

void add_bench(CommandLine& line) {
  CLI::App& bench = *line.app.add_subcommand("bench", "how fast graphs are solved, beside Ceres");
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
}

}  // namespace lanefuse
