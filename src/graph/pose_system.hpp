// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "graph/block_structure.hpp"
#include "graph/normal_equations.hpp"

namespace lanefuse {

/// The poses' part of the equations, once the landmarks are eliminated: dense Cholesky for few poses, else
/// sparse with an ordering of least fill. Poses are ordered as wholes, so that the three numbers of one are
/// eliminated together.
class PoseSystem {
 public:
  /// Analyses the pattern of a structure, which must outlive what follows.
  void prepare(const BlockStructure& structure);

  /// Solves for the poses' steps, which take the place of their right hand side. False if a pose is
  /// undetermined.
  bool solve(NormalEquations& equations);

 private:
  using SparseMatrix = Eigen::SparseMatrix<double>;

  void order_poses();
  void fill_pattern();
  bool solve_dense(NormalEquations& equations);
  bool solve_sparse(NormalEquations& equations);
  [[nodiscard]] bool all_determined(const NormalEquations& equations) const;

  const BlockStructure* structure_ = nullptr;
  std::vector<std::uint32_t> turn_of_pose_;  ///< when a pose is eliminated
  SparseMatrix matrix_;                      ///< by turns
  std::vector<std::size_t> source_;          ///< of each number of matrix_, in the equations' values
  Eigen::VectorXd rhs_;                      ///< by turns
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
};

}  // namespace lanefuse
