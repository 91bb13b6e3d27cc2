// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "graph/block_structure.hpp"
#include "graph/normal_equations.hpp"

namespace lanefuse {

/// The poses' part of the equations, once the landmarks are eliminated: dense Cholesky for few poses, else
/// sparse with an ordering of least fill.
class PoseSystem {
 public:
  /// Analyses the pattern of a structure, which must outlive what follows.
  void prepare(const BlockStructure& structure);

  /// Solves for the poses' steps, which take the place of their right hand side. False if a pose is
  /// undetermined.
  bool solve(NormalEquations& equations);

 private:
  void fill_pattern();
  bool solve_dense(NormalEquations& equations);
  bool solve_sparse(NormalEquations& equations);

  const BlockStructure* structure_ = nullptr;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
};

}  // namespace lanefuse
