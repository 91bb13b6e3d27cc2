// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "graph/soundness.hpp"
#include "graph/window_conversion.hpp"
#include "graph/window_solver.hpp"

namespace lanefuse {

namespace {

class CopyingSolver final : public WindowSolver {
 public:
  explicit CopyingSolver(std::unique_ptr<GraphSolver> solver) : solver_(std::move(solver)) {}

  SolveResult solve(WindowGraph& window, const SolverConfig& config) override {
    copy(window, graph_);
    const SolveResult result = solver_->solve(graph_, config);
    if (result.ok()) take_places(graph_, window);
    return result;
  }

 private:
  std::unique_ptr<GraphSolver> solver_;
  PoseGraph graph_;
};

class LaneGraphSolver final : public GraphSolver {
 public:
  SolveResult solve(PoseGraph& graph, const SolverConfig& config) override;
  void prepare(const PoseGraph& graph, const SolverConfig& config) override;
  SolveResult solve_prepared(PoseGraph& graph, const SolverConfig& config) override;

 private:
  void read_places(const PoseGraph& graph);
  void write_back(PoseGraph& graph) const;

  ConjugateGradientSolver solver_;
  std::unique_ptr<GraphSolver> direct_ = make_schur_solver();
  WindowOfGraph copy_;
  bool is_window_ = false;
};

SolveResult LaneGraphSolver::solve(PoseGraph& graph, const SolverConfig& config) {
  if (const auto fault = find_fault(graph)) {
    SolveResult result;
    result.status = *fault;
    return result;
  }
  prepare(graph, config);
  return solve_prepared(graph, config);
}

void LaneGraphSolver::prepare(const PoseGraph& graph, const SolverConfig& /*config*/) {
  is_window_ = to_window(graph, copy_);
}

SolveResult LaneGraphSolver::solve_prepared(PoseGraph& graph, const SolverConfig& config) {
  if (!is_window_) {
    SolveResult result = direct_->solve(graph, config);
    result.fallback = SolveFallback::not_a_window;
    return result;
  }
  read_places(graph);
  const SolveResult result = solver_.solve(copy_.window, config);
  if (result.ok()) write_back(graph);
  return result;
}

void LaneGraphSolver::read_places(const PoseGraph& graph) {
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    const Vertex& vertex = graph.vertices[v];
    if (vertex.role == VertexRole::pose || vertex.fixed) {
      copy_.window.place_pose(copy_.vertices[v], vertex.pose);
    } else {
      copy_.window.place_landmark(copy_.vertices[v], vertex.pose);
    }
  }
}

void LaneGraphSolver::write_back(PoseGraph& graph) const {
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    Vertex& vertex = graph.vertices[v];
    if (vertex.fixed) continue;
    const WindowGraph::Id id = copy_.vertices[v];
    vertex.pose = vertex.role == VertexRole::pose ? copy_.window.pose(id) : copy_.window.landmark(id);
  }
  for (std::size_t k = 0; k < graph.switches.size(); ++k) {
    if (copy_.switches[k] != WindowGraph::kNone)
      graph.switches[k].value = copy_.window.tie(copy_.switches[k]).switch_value;
  }
}

}  // namespace

std::unique_ptr<WindowSolver> make_window_solver(std::unique_ptr<GraphSolver> solver) {
  return std::make_unique<CopyingSolver>(std::move(solver));
}

std::unique_ptr<GraphSolver> make_lane_graph_solver() { return std::make_unique<LaneGraphSolver>(); }

}  // namespace lanefuse
