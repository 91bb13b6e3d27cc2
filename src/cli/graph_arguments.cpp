// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"
#include "cli/graph_command.hpp"
#include "cli/graph_files_command.hpp"

namespace lanefuse {
namespace {

constexpr const char* kPrior = "what it costs to switch a loop closure off, in chi2";

void add_solve(CLI::App& graph, CommandLine& line) {
  auto& options = line.make<GraphSolveOptions>();
  CLI::App& command = *graph.add_subcommand("solve", "find the optimum of a graph");
  command.add_option("file", options.file, "the graph (.g2o, or TORO's .graph)")->required();
  command.add_option("-o,--output", options.output, "the solved graph to write (.g2o, .graph)");
  command.add_option("--reference", options.reference, "a solution to say the distance to (.g2o, .graph)");
  command.add_option("--solver", options.solver, "lanefuse, direct, ceres or ceres:SETTING")
      ->capture_default_str();
  command.add_option("--max-iterations", options.max_iterations, "Gauss-Newton iterations at most")
      ->capture_default_str();
  command.add_flag("--switchable", options.switchable, "let every loop closure switch off");
  command.add_option("--switch-prior", options.switch_prior, kPrior)->capture_default_str();
  finish(command, line, options, graph_solve);
}

void add_convert(CLI::App& graph, CommandLine& line) {
  auto& options = line.make<GraphConvertOptions>();
  CLI::App& command = *graph.add_subcommand("convert", "write a graph in another format");
  command.add_option("file", options.file, "the graph (.g2o, .graph)")->required();
  command.add_option("output", options.output, "the graph to write (.g2o, .graph)")->required();
  finish(command, line, options, graph_convert);
}

void add_spoil(CLI::App& graph, CommandLine& line) {
  auto& options = line.make<GraphSpoilOptions>();
  CLI::App& command = *graph.add_subcommand("spoil", "add false loop closures to a graph");
  command.add_option("file", options.file, "the graph (.g2o, .graph)")->required();
  command.add_option("-o,--output", options.output, "the graph to write (.g2o, .graph)")->required();
  command.add_option("--outliers", options.outliers, "how many")->required()->check(not_negative);
  command.add_option("--seed", options.seed, "of what is drawn: same seed, same bytes")
      ->capture_default_str()
      ->check(not_negative);
  command.add_flag("--switchable", options.switchable, "write all loop closures as switchable edges");
  command.add_option("--switch-prior", options.switch_prior, kPrior)->capture_default_str();
  finish(command, line, options, graph_spoil);
}

void add_compare(CLI::App& graph, CommandLine& line) {
  auto& options = line.make<GraphCompareOptions>();
  CLI::App& command = *graph.add_subcommand("compare", "how far one solution lies from another (ATE)");
  command.add_option("a", options.a, "the one (.g2o, .graph)")->required();
  command.add_option("b", options.b, "the other (.g2o, .graph)")->required();
  finish(command, line, options, graph_compare);
}

}  // namespace

void add_graph(CommandLine& line) {
  CLI::App& graph = *line.app.add_subcommand("graph", "planar pose graphs, of lanes or of anything");
  demand_subcommand(graph);
  add_solve(graph, line);
  add_convert(graph, line);
  add_spoil(graph, line);
  add_compare(graph, line);
}

}  // namespace lanefuse
