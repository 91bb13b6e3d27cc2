// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/graph_command.hpp"

#include <chrono>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "graph/g2o.hpp"
#include "graph/loops.hpp"
#include "graph/solver.hpp"

namespace lanefuse {

namespace {

/// g2o's own switchable edges have the squared form; a hundred iterations of a cold start are let run to the
/// end.
SolverConfig solver_config(const GraphSolveOptions& options) {
  SolverConfig config;
  config.max_iterations = options.max_iterations;
  config.switch_form = SwitchForm::squared;
  return config;
}

void check(const GraphSolveOptions& options) {
  if (options.max_iterations < 0) {
    throw configuration_error("--max-iterations", fmt::format("{} is below 0", options.max_iterations));
  }
  if (options.output) check_output(*options.output, options.force, options.file);
}

nlohmann::ordered_json describe(const SolveResult& result, const PoseGraph& graph, double solve_ms) {
  return {{"status", to_string(result.status)},
          {"iterations", result.iterations},
          {"solve_ms", solve_ms},
          {"initial_chi2", result.initial_chi2},
          {"chi2", result.final_chi2},
          {"vertices", graph.vertices.size()},
          {"edges", graph.edges.size()}};
}

void print(const SolveResult& result, const PoseGraph& graph, double solve_ms, bool json) {
  if (json) {
    fmt::print("{}\n", describe(result, graph, solve_ms).dump());
    return;
  }
  fmt::print("{} after {} iterations, {:.1f} ms: chi2 {:.6f} -> {:.6f}; {} vertices, {} edges\n",
             to_string(result.status), result.iterations, solve_ms, result.initial_chi2, result.final_chi2,
             graph.vertices.size(), graph.edges.size());
}

void write(const G2oGraph& solved, const std::filesystem::path& output) {
  std::ostringstream text;
  write_g2o(text, solved);
  write_text(output, text.str());
}

}  // namespace

void graph_solve(const GraphSolveOptions& options) {
  check(options);
  G2oGraph read = read_g2o(options.file);
  if (options.switchable) make_loops_switchable(read.graph, 1.0);
  const auto solver = make_schur_solver();
  const auto begin = std::chrono::steady_clock::now();
  const SolveResult result = solver->solve(read.graph, solver_config(options));
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  if (!result.ok()) {
    throw input_error(options.file.string(),
                      fmt::format("the graph cannot be solved: {}", to_string(result.status)));
  }
  if (options.output) write(read, *options.output);
  print(result, read.graph, taken.count(), options.json);
}

}  // namespace lanefuse
