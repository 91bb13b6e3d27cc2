// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_command.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "graph/g2o.hpp"
#include "peers/named_solver.hpp"
#include "peers/solver_race.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Two iterations, whatever they gain; .g2o switches have the squared form.
SolverConfig cycle_config() {
  SolverConfig config;
  config.max_iterations = 2;
  config.relative_tolerance = 0;
  config.switch_form = SwitchForm::squared;
  return config;
}

bool is_number(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return !stem.empty() && stem.find_first_not_of("0123456789") == std::string::npos;
}

std::vector<std::filesystem::path> graphs_in(const std::filesystem::path& folder) {
  std::error_code failed;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    if (entry.path().extension() == ".g2o") files.push_back(entry.path());
  }
  if (failed) throw input_error(folder.string(), "cannot be read as a folder");
  if (files.empty()) throw input_error(folder.string(), "holds no .g2o file");
  std::sort(files.begin(), files.end());
  return files;
}

SolverRace make_race(const BenchOptions& options, const std::string& setting) {
  return {make_solver(options.solver), has_ceres() ? make_ceres_solver(setting) : nullptr, now_ms};
}

Json times_json(const SolverRace& race, const std::string& setting) {
  const SolverTimes& own = race.own();
  Json json{{"cycles", own.ms.size()},
            {"lanefuse_ms", own.percentile(0.5)},
            {"lanefuse_p95_ms", own.percentile(0.95)},
            {"lanefuse_p99_ms", own.percentile(0.99)}};
  if (!has_ceres()) {
    json.update({{"ceres_ms", nullptr}, {"ratio", nullptr}});
    return json;
  }
  const SolverTimes& peer = race.peer();
  json.update({{"ceres_ms", peer.percentile(0.5)},
               {"ceres_p95_ms", peer.percentile(0.95)},
               {"ceres_setting", setting},
               {"ratio", peer.percentile(0.5) / own.percentile(0.5)}});
  return json;
}

/// chi2 of the graph at its minimum, where it is left.
double converge(PoseGraph& graph) {
  SolverConfig config = cycle_config();
  config.max_iterations = 100;
  config.relative_tolerance = 1e-12;
  return make_solver("direct")->solve(graph, config).final_chi2;
}

/// A graph's cycles: from eight starts around its optimum, in turn.
Json measure_graph(const std::string& name, PoseGraph graph, const BenchOptions& options) {
  constexpr std::size_t kStarts = 8, kFewestCycles = 20;
  constexpr double kSigma = 0.01;
  const double optimum = converge(graph);
  Random random(1, "bench");
  std::vector<PoseGraph> starts;
  while (starts.size() < kStarts) starts.push_back(perturbed(graph, kSigma, random));
  const std::string setting = best_ceres_setting(std::span(starts).first(1), cycle_config(), now_ms);
  SolverRace race = make_race(options, setting);
  for (std::size_t i = 0; i < 2; ++i) race.run(starts[i], cycle_config());
  race.forget();
  const double end = now_ms() + 1000 * options.seconds;
  for (std::size_t cycle = 0; cycle < kFewestCycles || now_ms() < end; ++cycle) {
    race.run(starts[cycle % kStarts], cycle_config());
  }
  Json json{{"graph", name}, {"vertices", graph.vertices.size()}, {"edges", graph.edges.size()}};
  json.update(times_json(race, setting));
  json.update({{"chi2", race.own().last.final_chi2},
               {"optimum", optimum},
               {"cg_iterations", race.own().last.cg_iterations}});
  return json;
}

void print_head() {
  fmt::print("{:<24}{:>9}{:>8}{:>12}{:>10}{:>10}{:>8}{:>14}{:>5}  {}\n", "", "vertices", "edges",
             "lanefuse ms", "p95", "ceres ms", "ratio", "chi2", "cg", "best of ceres");
}

std::string number(const Json& value, const char* format) {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "-";
}

void print_row(const Json& row) {
  fmt::print("{:<24}{:>9}{:>8}{:>12.3f}{:>10.3f}{:>10}{:>8}{:>14.4f}{:>5}  {}\n",
             row["graph"].get<std::string>(), row["vertices"].get<std::size_t>(),
             row["edges"].get<std::size_t>(), row["lanefuse_ms"].get<double>(),
             row["lanefuse_p95_ms"].get<double>(), number(row["ceres_ms"], "{:.2f}"),
             number(row["ratio"], "{:.1f}"), row["chi2"].get<double>(), row["cg_iterations"].get<int>(),
             row.value("ceres_setting", std::string("(built without)")));
}

/// Some windows from all over the drive, for the search of Ceres's best setting.
std::vector<PoseGraph> samples(const std::vector<std::filesystem::path>& files) {
  constexpr std::size_t kSamples = 3;
  std::vector<PoseGraph> graphs;
  for (std::size_t i = 1; i <= kSamples; ++i) {
    graphs.push_back(read_g2o(files[i * (files.size() - 1) / kSamples]).graph);
  }
  return graphs;
}

}  // namespace

int bench_lane_graphs(const BenchOptions& options) {
  const auto files = graphs_in(options.folder);
  if (std::all_of(files.begin(), files.end(), is_number)) return bench_windows(options);
  Json rows = Json::array();
  if (!options.json) print_head();
  for (const auto& file : files) {
    const PoseGraph graph = read_g2o(file).graph;
    const auto add = [&](const std::string& name, const PoseGraph& part) {
      rows.push_back(measure_graph(name, part, options));
      if (!options.json) print_row(rows.back());
    };
    for (const double share : {0.25, 0.5, 0.75}) {
      if (options.sub_windows)
        add(fmt::format("{} {:.0f} %", file.stem().string(), 100 * share), sub_window(graph, share));
    }
    add(file.stem().string(), graph);
  }
  if (options.json) fmt::print("{}\n", Json{{"solver", options.solver}, {"graphs", rows}}.dump());
  return 0;
}

int bench_windows(const BenchOptions& options) {
  const auto files = graphs_in(options.folder);
  const std::string setting = best_ceres_setting(samples(files), cycle_config(), now_ms);
  SolverRace race = make_race(options, setting);
  double vertices = 0, edges = 0, chi2 = 0;
  int cg_iterations = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const PoseGraph graph = read_g2o(files[i]).graph;
    race.run(graph, cycle_config());
    vertices += static_cast<double>(graph.vertices.size()) / static_cast<double>(files.size());
    edges += static_cast<double>(graph.edges.size()) / static_cast<double>(files.size());
    chi2 += race.own().last.final_chi2;
    cg_iterations = std::max(cg_iterations, race.own().last.cg_iterations);
  }
  Json row{{"graph", options.folder.filename().string()},
           {"windows", files.size()},
           {"vertices", static_cast<std::size_t>(std::lround(vertices))},
           {"edges", static_cast<std::size_t>(std::lround(edges))}};
  row.update(times_json(race, setting));
  row.update({{"chi2", chi2}, {"cg_iterations", cg_iterations}, {"failed", race.own().failed}});
  if (options.json) {
    fmt::print("{}\n", Json{{"solver", options.solver}, {"windows", row}}.dump());
    return 0;
  }
  print_head();
  print_row(row);
  fmt::print("{} windows of {:.0f} vertices and {:.0f} edges on average; chi2 summed, most cg iterations\n",
             files.size(), vertices, edges);
  return 0;
}

}  // namespace lanefuse
