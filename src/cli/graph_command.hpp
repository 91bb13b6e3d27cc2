// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace lanefuse {

/// `lanefuse graph solve FILE.g2o`.
struct GraphSolveOptions {
  std::filesystem::path file;
  std::optional<std::filesystem::path> output;  ///< where the solved graph goes, as g2o text
  int max_iterations = 100;                     ///< at least 0
  bool switchable =
      false;  ///< give each loop closure a switch with prior 1 (switches of the file itself always count)
  bool json = false;   ///< the result on standard output as JSON, else as a line of text
  bool force = false;  ///< overwrite the output
};

/// Solves a planar pose graph and reports status, iterations, solve_ms, initial_chi2, chi2 (the sum of e'
/// Omega e), vertices and edges. Throws an Error for a file that cannot be read or solved, or an output that
/// cannot be written; one that cannot be solved is reported first.
void graph_solve(const GraphSolveOptions& options);

}  // namespace lanefuse
