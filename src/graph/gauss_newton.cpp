// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "graph/edge_terms.hpp"
#include "graph/landmark_elimination.hpp"
#include "graph/normal_equations.hpp"
#include "graph/pose_system.hpp"
#include "graph/solver.hpp"
#include "graph/soundness.hpp"
#include "graph/weak_terms.hpp"

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
  void begin(const PoseGraph& graph, const SolverConfig& config);
  SolveStatus iterate(const SolverConfig& config, SolveResult& result);
  std::optional<SolveStatus> advance(double tolerance, double& best_chi2);
  std::optional<SolveStatus> find_step();
  void lay_out();
  void take_step();
  void return_to_best();
  void back_off();
  [[nodiscard]] bool step_is_negligible() const;
  void write_back(PoseGraph& graph) const;

  EdgeTerms terms_;
  const PoseGraph* graph_ = nullptr;  ///< during a solve
  EliminationOrder order_;
  WeakTerms weak_;
  bool is_laid_out_ = false;
  BlockStructure structure_;
  NormalEquations equations_;
  PoseSystem poses_;
  std::vector<Placed> places_;  ///< of all vertices
  std::vector<Placed> best_places_;
  int steps_above_ = 0;  ///< in a row that ended above the best place
  Damping damping_;
};

SolveResult SchurSolver::solve(PoseGraph& graph, const SolverConfig& config) {
  SolveResult result;
  if (const auto fault = find_fault(graph)) {
    result.status = *fault;
    return result;
  }
  begin(graph, config);
  result.initial_chi2 = result.final_chi2 = terms_.evaluate(places_);
  result.status = std::isfinite(result.initial_chi2) ? iterate(config, result) : SolveStatus::not_finite;
  if (result.ok()) write_back(graph);
  return result;
}

void SchurSolver::begin(const PoseGraph& graph, const SolverConfig& config) {
  places_.clear();
  for (const Vertex& v : graph.vertices) places_.push_back(placed(v.pose.x, v.pose.y, v.pose.heading));
  best_places_ = places_;
  steps_above_ = 0;
  damping_ = {};
  terms_.prepare(graph, config.switch_form);
  order_.compute(graph);
  weak_.clear();
  graph_ = &graph;
  is_laid_out_ = false;
}

/// Works out where everything stands in the equations: at the start, and when weak terms have come or gone.
void SchurSolver::lay_out() {
  const bool has_many_poses = !BlockStructure::is_dense(order_.blocks() - order_.landmarks());
  if (has_many_poses && weak_.update(terms_, order_)) is_laid_out_ = false;
  if (is_laid_out_) return;
  structure_.compute(*graph_, order_, weak_);
  equations_.prepare(terms_, order_, structure_, weak_);
  poses_.prepare(structure_);
  is_laid_out_ = true;
}

/// Leaves places_ at the best place found, evaluated last.
SolveStatus SchurSolver::iterate(const SolverConfig& config, SolveResult& result) {
  if (order_.blocks() == 0) return SolveStatus::converged;
  while (result.iterations < config.max_iterations) {
    ++result.iterations;
    if (const auto end = advance(config.relative_tolerance, result.final_chi2)) return *end;
  }
  if (steps_above_ > 0) return_to_best();
  return SolveStatus::iterations_exhausted;
}

/// One iteration, which lowers `best_chi2` if it can; a status if it is the last.
std::optional<SolveStatus> SchurSolver::advance(double tolerance, double& best_chi2) {
  const bool plain = steps_above_ == 0 && damping_.value() == 0;
  if (const auto fault = find_step()) {
    if (steps_above_ == 0) return fault;
    back_off();
    return std::nullopt;
  }
  take_step();
  const double chi2 = terms_.evaluate(places_);
  const bool settled = plain && (std::abs(chi2 - best_chi2) <= tolerance * best_chi2 || step_is_negligible());
  if (chi2 <= best_chi2) {
    best_chi2 = chi2;
    best_places_ = places_;
    steps_above_ = 0;
    damping_.on_success();
  } else if (settled) {
    return_to_best();
  } else if (!std::isfinite(chi2) || damping_.value() > 0 || ++steps_above_ > kPatience) {
    back_off();
  }
  return settled ? std::optional(SolveStatus::converged) : std::nullopt;
}

/// Puts the step in place of the equations' right hand side, or says why there is none.
std::optional<SolveStatus> SchurSolver::find_step() {
  lay_out();
  equations_.assemble(terms_, places_, damping_.value());
  if (!eliminate_landmarks(structure_, equations_) || !poses_.solve(equations_)) return SolveStatus::singular;
  substitute_landmarks(structure_, equations_);
  if (!equations_.rhs.allFinite()) return SolveStatus::not_finite;
  return std::nullopt;
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

void SchurSolver::back_off() {
  return_to_best();
  steps_above_ = 0;
  damping_.on_failure();
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
