// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "graph/edge_terms.hpp"
#include "graph/landmark_elimination.hpp"
#include "graph/normal_equations.hpp"
#include "graph/pose_system.hpp"
#include "graph/solver.hpp"
#include "graph/soundness.hpp"

namespace lanefuse {

namespace {

Placed placed(double x, double y, double heading) {
  return {x, y, heading, std::cos(heading), std::sin(heading)};
}

/// How the step is damped: not at all while Gauss-Newton does its work, else as Levenberg and Marquardt do.
class Damping {
 public:
  [[nodiscard]] double value() const { return value_; }
  void on_success() { value_ = value_ <= kLeast ? 0 : value_ / 10; }
  void on_failure() { value_ = std::max(kLeast, 10 * value_); }

 private:
  static constexpr double kLeast = 1e-4;
  double value_ = 0;
};

class SchurSolver final : public GraphSolver {
 public:
  SolveResult solve(PoseGraph& graph, const SolverConfig& config) override;

 private:
  void prepare(const PoseGraph& graph, const SolverConfig& config);
  std::optional<SolveStatus> iterate(const SolverConfig& config, SolveResult& result);
  bool find_step(double damping);
  void take_step();
  [[nodiscard]] bool step_is_negligible() const;
  void write_back(PoseGraph& graph) const;

  EdgeTerms terms_;
  EliminationOrder order_;
  BlockStructure structure_;
  NormalEquations equations_;
  PoseSystem poses_;
  std::vector<Placed> places_;        ///< of all vertices
  std::vector<Placed> trial_places_;  ///< after the step that is being tried
};

SolveResult SchurSolver::solve(PoseGraph& graph, const SolverConfig& config) {
  SolveResult result;
  if (const auto fault = find_fault(graph)) {
    result.status = *fault;
    return result;
  }
  prepare(graph, config);
  result.initial_chi2 = result.final_chi2 = terms_.evaluate(places_);
  result.status = std::isfinite(result.initial_chi2)
                      ? iterate(config, result).value_or(SolveStatus::iterations_exhausted)
                      : SolveStatus::not_finite;
  if (result.ok()) write_back(graph);
  return result;
}

void SchurSolver::prepare(const PoseGraph& graph, const SolverConfig& config) {
  places_.clear();
  for (const Vertex& v : graph.vertices) places_.push_back(placed(v.pose.x, v.pose.y, v.pose.heading));
  terms_.prepare(graph, config.switch_form);
  order_.compute(graph);
  structure_.compute(graph, order_);
  equations_.prepare(terms_, order_, structure_);
  poses_.prepare(structure_);
}

/// Iterates until something is to be said; nothing, if the iterations run out.
std::optional<SolveStatus> SchurSolver::iterate(const SolverConfig& config, SolveResult& result) {
  if (structure_.blocks() == 0) return SolveStatus::converged;
  Damping damping;
  for (; result.iterations < config.max_iterations; ++result.iterations) {
    if (!find_step(damping.value())) return SolveStatus::singular;
    if (!equations_.rhs.allFinite()) return SolveStatus::not_finite;
    take_step();
    const double before = result.final_chi2;
    const double chi2 = terms_.evaluate(trial_places_);
    if (chi2 <= before) {
      places_.swap(trial_places_);
      result.final_chi2 = chi2;
      const bool settled = before - chi2 <= config.relative_tolerance * before;
      if (settled && damping.value() == 0) {
        ++result.iterations;
        return SolveStatus::converged;
      }
      damping.on_success();
      continue;
    }
    terms_.evaluate(places_);
    if (step_is_negligible()) {
      ++result.iterations;
      return SolveStatus::converged;
    }
    damping.on_failure();
  }
  return std::nullopt;
}

bool SchurSolver::find_step(double damping) {
  equations_.assemble(terms_, places_, damping);
  if (!eliminate_landmarks(structure_, equations_) || !poses_.solve(equations_)) return false;
  substitute_landmarks(structure_, equations_);
  return true;
}

void SchurSolver::take_step() {
  trial_places_ = places_;
  for (VertexId v = 0; v < places_.size(); ++v) {
    if (order_.block(v) == kHeld) continue;
    const auto step = equations_.rhs.segment<3>(3 * order_.block(v));
    const Placed& old = places_[v];
    trial_places_[v] = placed(old.x + step[0], old.y + step[1], wrap_angle(old.heading + step[2]));
  }
}

/// Whether the step is down in the rounding of the poses themselves.
bool SchurSolver::step_is_negligible() const {
  double farthest = 1;
  for (const Placed& place : places_) farthest = std::max({farthest, std::abs(place.x), std::abs(place.y)});
  return equations_.rhs.cwiseAbs().maxCoeff() <= 1e-11 * farthest;
}

void SchurSolver::write_back(PoseGraph& graph) const {
  for (VertexId v = 0; v < places_.size(); ++v) {
    if (order_.block(v) != kHeld) graph.vertices[v].pose = {places_[v].x, places_[v].y, places_[v].heading};
  }
  for (std::size_t k = 0; k < graph.switches.size(); ++k) graph.switches[k].value = terms_.switch_value(k);
}

}  // namespace

std::unique_ptr<GraphSolver> make_schur_solver() { return std::make_unique<SchurSolver>(); }

}  // namespace lanefuse
