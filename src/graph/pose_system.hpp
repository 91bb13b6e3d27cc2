// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graph/block_structure.hpp"
#include "graph/normal_equations.hpp"
#include "graph/sparse_cholesky.hpp"
#include "graph/supernodes.hpp"

namespace lanefuse {

/// The poses' part of the equations, once the landmarks are eliminated: dense Cholesky for few poses, else
/// sparse by panels with an ordering of little fill. Poses are ordered as wholes, so that the three numbers
/// of one are eliminated together.
class PoseSystem {
 public:
  /// Analyses the pattern of a structure, which must outlive what follows.
  void prepare(const BlockStructure& structure);

  /// Solves for the poses' steps, which take the place of their right hand side. False if a pose is
  /// undetermined.
  bool solve(NormalEquations& equations);

 private:
  struct BlockPlace {
    std::size_t source = 0;  ///< in the equations' values
    std::size_t target = 0;  ///< in the factor's
    std::size_t source_stride = 0;
    std::size_t row_stride = 0;  ///< of the target
    std::size_t column_stride = 0;
  };

  void fill_pattern();
  void place_blocks();
  bool solve_dense(NormalEquations& equations);
  bool solve_sparse(NormalEquations& equations);
  [[nodiscard]] bool all_determined(const NormalEquations& equations) const;

  const BlockStructure* structure_ = nullptr;
  Supernodes supernodes_;
  SparseCholesky factor_;
  std::vector<BlockPlace> blocks_;
  Eigen::VectorXd rhs_;  ///< by turns
};

}  // namespace lanefuse
