// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/graph_command.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/graph_files_command.hpp"
#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "graph/g2o.hpp"
#include "graph/graph_file.hpp"
#include "graph/loops.hpp"
#include "peers/named_solver.hpp"

namespace lanefuse {

namespace {

/// What a solve came to.
struct Outcome {
  SolveResult result;
  double solve_ms = 0;
  std::ptrdiff_t switches_off = 0;
  std::optional<PlaceComparison> from_reference;
};

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
  if (!(options.switch_prior > 0)) {
    throw configuration_error("--switch-prior", fmt::format("{} is not above 0", options.switch_prior));
  }
  if (!options.output) return;
  check_output(*options.output, options.force, options.file);
  if (options.reference) check_output(*options.output, options.force, *options.reference);
  graph_format(*options.output);
}

Outcome solve(GraphSolver& solver, PoseGraph& graph, const GraphSolveOptions& options) {
  Outcome outcome;
  const auto begin = std::chrono::steady_clock::now();
  outcome.result = solver.solve(graph, solver_config(options));
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  outcome.solve_ms = taken.count();
  outcome.switches_off = std::count_if(graph.switches.begin(), graph.switches.end(),
                                       [](const Switch& s) { return s.value < 0.5; });
  if (outcome.result.ok()) return outcome;
  throw input_error(options.file.string(),
                    fmt::format("the graph cannot be solved: {}", to_string(outcome.result.status)));
}

void print_json(const Outcome& outcome, const PoseGraph& graph, const std::string& solver) {
  nlohmann::ordered_json json{
      {"status", to_string(outcome.result.status)},  {"solver", solver},
      {"iterations", outcome.result.iterations},     {"solve_ms", outcome.solve_ms},
      {"initial_chi2", outcome.result.initial_chi2}, {"chi2", outcome.result.final_chi2},
      {"vertices", graph.vertices.size()},           {"edges", graph.edges.size()},
      {"switches", graph.switches.size()},           {"switches_off", outcome.switches_off}};
  if (outcome.from_reference) json["reference"] = describe(*outcome.from_reference);
  fmt::print("{}\n", json.dump());
}

void print_text(const Outcome& outcome, const PoseGraph& graph) {
  fmt::print("{} after {} iterations, {:.1f} ms: chi2 {:.6f} -> {:.6f}; {} vertices, {} edges\n",
             to_string(outcome.result.status), outcome.result.iterations, outcome.solve_ms,
             outcome.result.initial_chi2, outcome.result.final_chi2, graph.vertices.size(),
             graph.edges.size());
  if (!graph.switches.empty()) {
    fmt::print("switches: {}, off {}\n", graph.switches.size(), outcome.switches_off);
  }
  if (outcome.from_reference) fmt::print("{}\n", in_words(*outcome.from_reference));
}

}  // namespace

int graph_solve(const GraphSolveOptions& options) {
  check(options);
  const auto solver = make_solver(options.solver);
  G2oGraph read = read_g2o(options.file);
  std::optional<G2oGraph> reference;
  if (options.reference) reference = read_g2o(*options.reference);
  if (options.switchable) {
    make_loops_switchable(read.graph, options.switch_prior);
    number_new_switches(read);
  }
  Outcome outcome = solve(*solver, read.graph, options);
  if (reference) outcome.from_reference = compare_places(read, *reference);
  if (options.output) {
    const GraphFormat format = graph_format(*options.output);
    tell_losses(*options.output, lost_in(format, read));
    write_text(*options.output, graph_text(read, format));
  }
  if (options.json) {
    print_json(outcome, read.graph, options.solver);
  } else {
    print_text(outcome, read.graph);
  }
  return 0;
}

}  // namespace lanefuse
