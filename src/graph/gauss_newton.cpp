// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

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

/// From a poor start Gauss-Newton often climbs for a step or two and then drops far below where damping would
/// have crept. So many steps in a row it may lie above its best place before it is called back there and
/// damped.
constexpr int kPatience = 4;

class SchurSolver final : public GraphSolver {
 public:
  SolveResult solve(PoseGraph& graph, const SolverConfig& config) override;

 private:
  void prepare(const PoseGraph& graph, const SolverConfig& config);
  SolveStatus iterate(const SolverConfig& config, SolveResult& result);
  bool find_step();
  void take_step();
  void return_to_best();
  [[nodiscard]] bool step_is_negligible() const;
  void write_back(PoseGraph& graph) const;

  EdgeTerms terms_;
  EliminationOrder order_;
  BlockStructure structure_;
  NormalEquations equations_;
  PoseSystem poses_;
  std::vector<Placed> places_;  ///< of all vertices
  std::vector<Placed> best_places_;
  Damping damping_;
};

SolveResult SchurSolver::solve(PoseGraph& graph, const SolverConfig& config) {
  SolveResult result;
  if (const auto fault = find_fault(graph)) {
    result.status = *fault;
    return result;
  }
  prepare(graph, config);
  result.initial_chi2 = result.final_chi2 = terms_.evaluate(places_);
  result.status = std::isfinite(result.initial_chi2) ? iterate(config, result) : SolveStatus::not_finite;
  if (result.ok()) write_back(graph);
  return result;
}

void SchurSolver::prepare(const PoseGraph& graph, const SolverConfig& config) {
  places_.clear();
  for (const Vertex& v : graph.vertices) places_.push_back(placed(v.pose.x, v.pose.y, v.pose.heading));
  best_places_ = places_;
  damping_ = {};
  terms_.prepare(graph, config.switch_form);
  order_.compute(graph);
  structure_.compute(graph, order_);
  equations_.prepare(terms_, order_, structure_);
  poses_.prepare(structure_);
}

/// Leaves places_ at the best place found, evaluated last.
SolveStatus SchurSolver::iterate(const SolverConfig& config, SolveResult& result) {
  if (structure_.blocks() == 0) return SolveStatus::converged;
  int above = 0;  // steps in a row that ended above the best place
  while (result.iterations < config.max_iterations) {
    ++result.iterations;
    const double best = result.final_chi2;
    const bool from_best = above == 0;
    if (!find_step()) {
      if (from_best) return SolveStatus::singular;
    } else if (!equations_.rhs.allFinite()) {
      return SolveStatus::not_finite;
    } else {
      take_step();
      const double chi2 = terms_.evaluate(places_);
      const bool settled =
          from_best && damping_.value() == 0 &&
          (std::abs(chi2 - best) <= config.relative_tolerance * best || step_is_negligible());
      if (chi2 <= best) {
        best_places_ = places_;
        result.final_chi2 = chi2;
        above = 0;
        damping_.on_success();
      }
      if (settled) {
        if (chi2 > best) return_to_best();
        return SolveStatus::converged;
      }
      if (chi2 <= best) continue;
      if (std::isfinite(chi2) && damping_.value() == 0 && ++above <= kPatience) continue;
    }
    return_to_best();
    above = 0;
    damping_.on_failure();
  }
  if (above > 0) return_to_best();
  return SolveStatus::iterations_exhausted;
}

bool SchurSolver::find_step() {
  equations_.assemble(terms_, places_, damping_.value());
  if (!eliminate_landmarks(structure_, equations_) || !poses_.solve(equations_)) return false;
  substitute_landmarks(structure_, equations_);
  return true;
}

void SchurSolver::take_step() {
  for (VertexId v = 0; v < places_.size(); ++v) {
    if (order_.block(v) == kHeld) continue;
    const auto step = equations_.rhs.segment<3>(3 * order_.block(v));
    const Placed& old = places_[v];
    places_[v] = placed(old.x + step[0], old.y + step[1], wrap_angle(old.heading + step[2]));
  }
}

void SchurSolver::return_to_best() {
  places_ = best_places_;
  terms_.evaluate(places_);
}

/// Whether the step is down in the rounding of the poses themselves.
bool SchurSolver::step_is_negligible() const {
  double farthest = 1;
  for (const Placed& place : places_) farthest = std::max({farthest, std::abs(place.x), std::abs(place.y)});
  return equations_.rhs.cwiseAbs().maxCoeff() <= 1e-12 * farthest;
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
