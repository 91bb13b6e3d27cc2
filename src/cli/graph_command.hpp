// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lanefuse {

/// `lanefuse graph solve FILE`.
struct GraphSolveOptions {
  std::filesystem::path file;
  std::optional<std::filesystem::path> output;     ///< where the solved graph goes
  std::optional<std::filesystem::path> reference;  ///< a solution to compare with: the ATE
  std::string solver = "lanefuse";                 ///< lanefuse, direct, ceres or ceres:SETTING
  int max_iterations = 100;                        ///< at least 0
  bool switchable = false;  ///< give each loop closure a switch (those of the file itself always count)
  double switch_prior = 1;  ///< of these switches: what it costs to turn a closure off
  bool json = false;        ///< the result on standard output as JSON, else as a line of text
  bool force = false;       ///< overwrite the output
};

/// Solves a planar pose graph and reports status, solver, iterations, solve_ms (from the graph in memory to
/// the optimum), initial_chi2, chi2 (the sum of e' Omega e), vertices, edges, and how many switches there are
/// and stand below one half; with a reference also how far the places are from it. Throws an Error for a file
/// that cannot be read or solved, or an output that cannot be written.
int graph_solve(const GraphSolveOptions& options);

}  // namespace lanefuse
