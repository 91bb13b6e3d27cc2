// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "peers/ceres_solver.hpp"

namespace lanefuse {

/// Milliseconds since whenever; handed in, as no library of ours reads a clock.
using MillisecondClock = std::function<double()>;

/// What a solver took and came to, cycle by cycle.
struct SolverTimes {
  std::vector<double> ms;  ///< one a cycle
  SolveResult last;
  int failed = 0;  ///< cycles that ended without a solution

  /// By nearest rank, 0 for no cycles; share in (0, 1].
  [[nodiscard]] double percentile(double share) const;
};

/// Solves the same starts with one of our solvers and with Ceres, turn by turn, so that whatever else the
/// machine does falls on both. Only solving counts: neither copying the start nor taking over what does not
/// move, as a problem of Ceres or as a window of ours.
class SolverRace {
 public:
  /// `peer` may be null: then ours runs alone.
  SolverRace(std::unique_ptr<GraphSolver> own, std::unique_ptr<GraphSolver> peer, MillisecondClock clock);

  /// One cycle from this start with each.
  void run(const PoseGraph& start, const SolverConfig& config);

  /// Forgets the times so far: the first cycles fill caches and workspaces.
  void forget();

  [[nodiscard]] const SolverTimes& own() const { return own_times_; }
  [[nodiscard]] const SolverTimes& peer() const { return peer_times_; }

 private:
  void time(GraphSolver& solver, const PoseGraph& start, const SolverConfig& config, SolverTimes& times);

  std::unique_ptr<GraphSolver> own_;
  std::unique_ptr<GraphSolver> peer_;
  MillisecondClock clock_;
  SolverTimes own_times_;
  SolverTimes peer_times_;
  PoseGraph graph_;  ///< scratch
};

/// The setting of Ceres that solves these starts in the least time: each start three times, the best counts.
/// Empty without Ceres.
std::string best_ceres_setting(std::span<const PoseGraph> starts, const SolverConfig& config,
                               const MillisecondClock& clock);

/// The graph with its free vertices moved a little, as the last cycle's solution is off by what the new
/// measurements say: normal, sigma [m] for each axis and a tenth of it [rad] for the heading.
PoseGraph perturbed(PoseGraph graph, double sigma, Random& random);

/// The part of a graph that has this share of its landmarks, the first ones, with all poses.
PoseGraph sub_window(const PoseGraph& graph, double share);

}  // namespace lanefuse
