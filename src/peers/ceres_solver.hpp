// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "graph/solver.hpp"

namespace lanefuse {

/// Whether the program was built with Ceres.
bool has_ceres();

/// The names of the settings that are worth a try, most usual first: linear solver, preconditioner, kind of
/// sparsity. Empty without Ceres.
std::vector<std::string> ceres_settings();

/// Ceres as a GraphSolver: the same cost from the same start, by other people's means. It judges our results
/// and is what our times are measured against, so it is given its best: analytic Jacobians, closed-form
/// switches as loss functions, one thread, no damping until a step fails, and a problem that is kept for as
/// long as only the vertices move.
///
/// Throws a configuration Error if the program was built without Ceres, or no setting has this name (empty:
/// the first). What solve() does not say as ours does: a graph that leaves vertices undetermined is damped by
/// Ceres and not called singular; edges that share a switch throw a configuration Error.
std::unique_ptr<GraphSolver> make_ceres_solver(std::string_view setting = {});

}  // namespace lanefuse
