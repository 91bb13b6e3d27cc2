// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "graph/solver.hpp"

namespace lanefuse {

/// The solvers that a command can be asked for by name: `lanefuse` (what the program itself uses), `direct`
/// (Gauss-Newton with block Schur complement and sparse Cholesky factorisation), `ceres`.
std::vector<std::string> solver_names();

/// Throws a configuration Error for a name that is none, or a solver that the program was built without.
/// `ceres` may be followed by one of its settings: `ceres:dense_schur`.
std::unique_ptr<GraphSolver> make_solver(std::string_view name);

}  // namespace lanefuse
