// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/endurance_command.hpp"

#include <chrono>
#include <ctime>
#include <fstream>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/endurance.hpp"
#include "core/error.hpp"
#include "graph/window_solver.hpp"
#include "peers/named_solver.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

double wall_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// 0 where the system does not say.
double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  double total = 0;
  double resident = 0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

Json to_json(const EnduranceStretch& s, const std::string& estimator, const std::string& solver) {
  return {
      {"estimator", estimator},
      {"solver", solver},
      {"hours", s.end_hours},
      {"cycles", s.cycles},
      {"not_ok", s.not_ok},
      {"cycle_ms", {{"p50", s.p50_ms}, {"p99", s.p99_ms}, {"max", s.max_ms}}},
      {"cycle_cpu_ms", {{"p99", s.cpu_p99_ms}, {"max", s.cpu_max_ms}}},
      {"resident_mb", s.resident_mb},
      {"graph", {{"poses", s.largest.poses}, {"features", s.largest.features}, {"edges", s.largest.edges}}},
      {"inputs", {{"used", s.inputs.used}, {"rejected", s.inputs.rejected}, {"dropped", s.inputs.dropped}}}};
}

void print_row(const EnduranceStretch& s, const std::string& solver) {
  fmt::print("{:<24}{:>7.2f}{:>9}{:>8}{:>9.2f}{:>8.2f}{:>8.2f}{:>10.2f}{:>9.2f}{:>9.1f}{:>7}{:>10}{:>8}\n",
             solver, s.end_hours, s.cycles, s.not_ok, s.p50_ms, s.p99_ms, s.max_ms, s.cpu_p99_ms,
             s.cpu_max_ms, s.resident_mb, s.largest.poses, s.largest.features, s.largest.edges);
  std::fflush(stdout);
}

}  // namespace

int bench_endurance(const EnduranceOptions& options) {
  EnduranceConfig config;
  config.estimator = options.estimator == "road" ? EstimatorKind::road : EstimatorKind::graph;
  if (config.estimator != EstimatorKind::graph && !options.beside.empty()) {
    throw configuration_error("--beside",
                              fmt::format("estimator {} has no graph to solve", options.estimator),
                              "leave it out, or choose --estimator graph");
  }
  config.seed = options.seed;
  config.hours = options.hours;
  config.cycle_hz = options.cycle_hz;
  config.detections = options.detections;
  if (options.scenario != "nominal") config.scenario = find_scenario(options.scenario);
  Json rows = Json::array();
  if (!options.json) {
    fmt::print("{:<24}{:>7}{:>9}{:>8}{:>9}{:>8}{:>8}{:>10}{:>9}{:>9}{:>7}{:>10}{:>8}\n", "solver", "hours",
               "cycles", "not OK", "p50 ms", "p99", "max", "cpu p99", "max", "MB", "poses", "features",
               "edges");
  }
  std::vector<std::string> names{config.estimator == EstimatorKind::graph ? "lanefuse" : options.estimator};
  std::vector<std::unique_ptr<WindowSolver>> solvers(1);
  for (const std::string& name : options.beside) {
    names.push_back(name);
    solvers.push_back(make_window_solver(make_solver(name)));
  }
  drive_endurance(config, options.report_minutes / 60, {wall_ms, cpu_ms, resident_mb}, std::move(solvers),
                  [&](const EnduranceStretch& stretch) {
                    rows.push_back(to_json(stretch, options.estimator, names[stretch.solver]));
                    if (!options.json) print_row(stretch, names[stretch.solver]);
                  });
  if (options.json) fmt::print("{}\n", Json{{"stretches", rows}}.dump());
  return 0;
}

}  // namespace lanefuse
