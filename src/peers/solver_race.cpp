// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/solver_race.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/percentile.hpp"

namespace lanefuse {

double SolverTimes::percentile(double share) const { return lanefuse::percentile(ms, share); }

SolverRace::SolverRace(std::unique_ptr<GraphSolver> own, std::unique_ptr<GraphSolver> peer,
                       MillisecondClock clock)
    : own_(std::move(own)), peer_(std::move(peer)), clock_(std::move(clock)) {}

void SolverRace::run(const PoseGraph& start, const SolverConfig& config) {
  time(*own_, start, config, own_times_);
  if (peer_) time(*peer_, start, config, peer_times_);
}

void SolverRace::time(GraphSolver& solver, const PoseGraph& start, const SolverConfig& config,
                      SolverTimes& times) {
  graph_ = start;
  solver.prepare(graph_, config);
  const double begin = clock_();
  times.last = solver.solve_prepared(graph_, config);
  times.ms.push_back(clock_() - begin);
  times.failed += times.last.ok() ? 0 : 1;
}

void SolverRace::forget() {
  own_times_ = {};
  peer_times_ = {};
}

std::string best_ceres_setting(std::span<const PoseGraph> starts, const SolverConfig& config,
                               const MillisecondClock& clock) {
  constexpr int kRepeats = 3;
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::string& setting : ceres_settings()) {
    const auto solver = make_ceres_solver(setting);
    double sum = 0;
    for (const PoseGraph& start : starts) {
      double fastest = std::numeric_limits<double>::infinity();
      for (int repeat = 0; repeat < kRepeats && sum < least; ++repeat) {
        PoseGraph graph = start;
        solver->prepare(graph, config);
        const double begin = clock();
        const bool solved = solver->solve_prepared(graph, config).ok();
        if (solved) fastest = std::min(fastest, clock() - begin);
      }
      sum += fastest;
    }
    if (sum >= least) continue;
    least = sum;
    best = setting;
  }
  return best;
}

PoseGraph perturbed(PoseGraph graph, double sigma, Random& random) {
  for (Vertex& vertex : graph.vertices) {
    if (vertex.fixed) continue;
    vertex.pose.x += random.normal(sigma);
    vertex.pose.y += random.normal(sigma);
    vertex.pose.heading = wrap_angle(vertex.pose.heading + random.normal(sigma / 10));
  }
  return graph;
}

PoseGraph sub_window(const PoseGraph& graph, double share) {
  const auto landmarks = std::count_if(graph.vertices.begin(), graph.vertices.end(),
                                       [](const Vertex& v) { return v.role == VertexRole::landmark; });
  const double most = share * static_cast<double>(landmarks);
  constexpr VertexId kGone = 0xffffffff;
  PoseGraph part;
  std::vector<VertexId> renumbered;
  double kept = 0;
  for (const Vertex& vertex : graph.vertices) {
    const bool stays = vertex.role == VertexRole::pose || kept + 1 <= most;
    renumbered.push_back(stays ? static_cast<VertexId>(part.vertices.size()) : kGone);
    if (!stays) continue;
    part.vertices.push_back(vertex);
    kept += vertex.role == VertexRole::landmark ? 1 : 0;
  }
  for (Edge edge : graph.edges) {
    edge.from = renumbered[edge.from];
    edge.to = renumbered[edge.to];
    if (edge.from == kGone || edge.to == kGone) continue;
    if (edge.switch_index != kNoSwitch) {
      part.switches.push_back(graph.switches[edge.switch_index]);
      edge.switch_index = static_cast<std::uint32_t>(part.switches.size() - 1);
    }
    part.edges.push_back(edge);
  }
  return part;
}

}  // namespace lanefuse
