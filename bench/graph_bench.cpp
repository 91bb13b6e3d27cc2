// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// What a cycle pays for the graph: two Gauss-Newton iterations on a sliding window of lane features.
#include <string>

#include <benchmark/benchmark.h>

#include "graph/g2o.hpp"
#include "graph/solver.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

/// The window as the file gives it, or none if the real data is not there (the benchmark then says so).
PoseGraph window(benchmark::State& state, const std::string& name) {
  const auto file = testing::real_data("lane_graphs/" + name + ".g2o");
  if (std::filesystem::exists(file)) return read_g2o(file).graph;
  state.SkipWithError("no real data: set LANEFUSE_DATA");
  return {};
}

void measure(benchmark::State& state, const PoseGraph& start) {
  SolverConfig config;
  config.max_iterations = 2;
  config.relative_tolerance = 0;  // both iterations, whatever they gain
  const auto solver = make_schur_solver();
  SolveResult result;
  for (auto _ : state) {
    state.PauseTiming();
    PoseGraph graph = start;
    state.ResumeTiming();
    result = solver->solve(graph, config);
  }
  state.counters["chi2"] = result.final_chi2;
  state.counters["vertices"] = static_cast<double>(start.vertices.size());
  state.counters["edges"] = static_cast<double>(start.edges.size());
}

/// From the start that the file gives, before any optimisation.
void from_file(benchmark::State& state, const std::string& name) { measure(state, window(state, name)); }

/// From near the optimum, as a cycle starts from the last one's solution.
void warm(benchmark::State& state, const std::string& name) {
  PoseGraph graph = window(state, name);
  make_schur_solver()->solve(graph, {});
  measure(state, graph);
}

BENCHMARK_CAPTURE(from_file, light, "light")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(from_file, typical, "typical")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(from_file, heavy, "heavy")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(warm, light, "light")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(warm, typical, "typical")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(warm, heavy, "heavy")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(warm, typical_switch, "typical_switch")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lanefuse
