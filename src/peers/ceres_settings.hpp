// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <ceres/solver.h>

#include "peers/ceres_problem.hpp"

namespace lanefuse {

/// A way to set Ceres up.
struct CeresSetting {
  std::string name;
  ceres::LinearSolverType linear_solver = ceres::SPARSE_NORMAL_CHOLESKY;
  ceres::PreconditionerType preconditioner = ceres::JACOBI;
  ceres::SparseLinearAlgebraLibraryType sparse_library = ceres::SUITE_SPARSE;
  bool dynamic_sparsity = false;
  bool landmarks_first = false;  ///< our elimination groups instead of Ceres's own choice
};

/// All settings that are worth a try and that this Ceres has.
const std::vector<CeresSetting>& all_ceres_settings();

/// The options of a setting: one thread, silent, and as near to Gauss-Newton as Ceres comes: a trust region
/// so large that it does not damp until a step fails, and steps uphill for as long as ours are patient.
ceres::Solver::Options ceres_options(const CeresSetting& setting, const CeresProblem& problem);

}  // namespace lanefuse
