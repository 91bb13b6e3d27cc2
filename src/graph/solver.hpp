// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "graph/pose_graph.hpp"

namespace lanefuse {

struct SolverConfig {
  int max_iterations = 2;  ///< steps tried; a warm-started window needs one or two, a cold start up to 100
  double relative_tolerance = 1e-9;  ///< stop when chi2 changes by no more than this share; >= 0
  SwitchForm switch_form = SwitchForm::linear;
  /// Conjugate gradients stop when the residual is this small a share of the first, in the norm of the
  /// preconditioner; in (0, 1).
  double cg_tolerance = 0.03;
  int max_cg_iterations = 30;  ///< a step; where they do not do, the direct solver takes over
};

enum class SolveStatus : std::uint8_t {
  converged = 0,
  iterations_exhausted = 1,  ///< improved, but not to the tolerance: usual for a warm-started window
  singular = 2,              ///< the graph leaves vertices undetermined; nothing was changed
  not_finite = 3,            ///< a number in or out is not finite; nothing was changed
  no_fixed_vertex = 4,       ///< nothing holds the gauge; nothing was changed
  bad_edge = 5,  ///< an edge from a vertex to itself, or to a vertex or switch that is not there, or a switch
                 ///< whose prior is not positive; nothing was changed
};
const char* to_string(SolveStatus status);

/// Why the direct solver had to take over.
enum class SolveFallback : std::uint8_t {
  none = 0,
  not_a_window = 1,        ///< the graph is no chain of poses that see landmarks
  cg_struggled = 2,        ///< too many iterations
  negative_curvature = 3,  ///< rounding has made the equations indefinite
};
const char* to_string(SolveFallback fallback);

struct SolveResult {
  SolveStatus status = SolveStatus::converged;
  int iterations = 0;       ///< steps tried
  int cg_iterations = 0;    ///< of conjugate gradients, in all of them together; 0 for a direct solver
  double initial_chi2 = 0;  ///< J(V) at the start, with each switch at its best for it
  double final_chi2 = 0;    ///< J(V) as it was left; never above initial_chi2
  int halvings = 0;         ///< of steps whose end lay higher than their beginning (conjugate gradients)
  SolveFallback fallback = SolveFallback::none;
  [[nodiscard]] bool ok() const { return status <= SolveStatus::iterations_exhausted; }
};

/// Minimises J(V) [IROS16, sec. II-E] from where the vertices stand. Keeps its workspace between calls: one
/// object a thread.
class GraphSolver {
 public:
  virtual ~GraphSolver() = default;
  /// Moves the vertices and switches of `graph` towards the minimum; on failure leaves them bit by bit as
  /// they were.
  virtual SolveResult solve(PoseGraph& graph, const SolverConfig& config) = 0;

  /// For graphs that are solved again and again with nothing but the places of their vertices changed: takes
  /// over all else. `graph` must be sound: what solve() would refuse is not noticed.
  virtual void prepare(const PoseGraph& /*graph*/, const SolverConfig& /*config*/) {}
  /// As solve(), for the graph of the last prepare().
  virtual SolveResult solve_prepared(PoseGraph& graph, const SolverConfig& config) {
    return solve(graph, config);
  }
};

/// Gauss-Newton with the landmarks eliminated block by block onto the poses (Schur complement, Eigen), and
/// the switches in closed form. A step that leads uphill is followed for a few more, then taken back and
/// damped. The result depends on the graph alone, not on what was solved before.
std::unique_ptr<GraphSolver> make_schur_solver();

}  // namespace lanefuse
