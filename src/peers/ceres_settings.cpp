// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/ceres_settings.hpp"

#include <memory>

namespace lanefuse {

const std::vector<CeresSetting>& all_ceres_settings() {
  using namespace ceres;
  static const std::vector<CeresSetting> settings{
      {"sparse_normal_cholesky"},
      {"sparse_normal_cholesky_eigen", SPARSE_NORMAL_CHOLESKY, JACOBI, EIGEN_SPARSE},
      {"sparse_normal_cholesky_dynamic", SPARSE_NORMAL_CHOLESKY, JACOBI, SUITE_SPARSE, true},
      {"dense_schur", DENSE_SCHUR},
      {"dense_schur_landmarks_first", DENSE_SCHUR, JACOBI, SUITE_SPARSE, false, true},
      {"sparse_schur", SPARSE_SCHUR},
      {"sparse_schur_landmarks_first", SPARSE_SCHUR, JACOBI, SUITE_SPARSE, false, true},
      {"iterative_schur", ITERATIVE_SCHUR, SCHUR_JACOBI},
      {"iterative_schur_landmarks_first", ITERATIVE_SCHUR, SCHUR_JACOBI, SUITE_SPARSE, false, true},
      {"conjugate_gradients", CGNR},
  };
  return settings;
}

ceres::Solver::Options ceres_options(const CeresSetting& setting, const CeresProblem& problem) {
  ceres::Solver::Options options;
  options.linear_solver_type = setting.linear_solver;
  options.preconditioner_type = setting.preconditioner;
  options.sparse_linear_algebra_library_type = setting.sparse_library;
  options.dynamic_sparsity = setting.dynamic_sparsity;
  if (setting.landmarks_first && !problem.groups()[0].empty()) {
    options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    for (int group = 0; group < 2; ++group) {
      for (double* place : problem.groups()[static_cast<std::size_t>(group)]) {
        options.linear_solver_ordering->AddElementToGroup(place, group);
      }
    }
  }
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.initial_trust_region_radius = 1e16;
  options.max_trust_region_radius = 1e32;
  options.use_nonmonotonic_steps = true;
  options.max_consecutive_nonmonotonic_steps = 4;
  options.gradient_tolerance = 0;
  options.parameter_tolerance = 0;
  options.eta = 1e-3;  // conjugate gradients: how exact a step must be
  return options;
}

}  // namespace lanefuse
