// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/pose_system.hpp"

#include <algorithm>

#include <Eigen/Cholesky>

#include "graph/landmark_elimination.hpp"

namespace lanefuse {

namespace {

/// The poses' part of a vector with three numbers a block.
auto pose_part(const BlockStructure& structure, Eigen::VectorXd& all) {
  return all.tail(3 * structure.poses());
}

}  // namespace

void PoseSystem::prepare(const BlockStructure& structure) {
  structure_ = &structure;
  if (structure.poses_are_dense()) return;
  fill_pattern();
  factor_.analyzePattern(matrix_);
}

void PoseSystem::fill_pattern() {
  const auto side = static_cast<int>(3 * structure_->poses());
  matrix_.resize(side, side);
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(structure_->value_count() - structure_->pose_values()));
  int* column_begin = matrix_.outerIndexPtr();
  int* row = matrix_.innerIndexPtr();
  *column_begin = 0;
  for (std::uint32_t block = structure_->landmarks(); block < structure_->blocks(); ++block) {
    for (int c = 0; c < 3; ++c) {
      for (const std::uint32_t row_block : structure_->rows(block)) {
        for (std::uint32_t r = 0; r < 3; ++r)
          *row++ = static_cast<int>(3 * (row_block - structure_->landmarks()) + r);
      }
      *++column_begin = static_cast<int>(row - matrix_.innerIndexPtr());
    }
  }
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
}

bool PoseSystem::solve(NormalEquations& equations) {
  if (structure_->poses() == 0) return true;
  return structure_->poses_are_dense() ? solve_dense(equations) : solve_sparse(equations);
}

bool PoseSystem::solve_dense(NormalEquations& equations) {
  const Eigen::Index side = 3 * structure_->poses();
  Eigen::Map<Eigen::MatrixXd> matrix(equations.values.data() + structure_->pose_values(), side, side);
  Eigen::Ref<Eigen::MatrixXd> in_place(matrix);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> factor(in_place);
  if (factor.info() != Eigen::Success) return false;
  const auto diagonal = pose_part(*structure_, equations.diagonal);
  for (Eigen::Index i = 0; i < side; ++i) {
    if (!is_determined(matrix(i, i) * matrix(i, i), diagonal[i])) return false;
  }
  auto rhs = pose_part(*structure_, equations.rhs);
  factor.solveInPlace(rhs);
  return true;
}

bool PoseSystem::solve_sparse(NormalEquations& equations) {
  std::copy(equations.values.begin() + static_cast<std::ptrdiff_t>(structure_->pose_values()),
            equations.values.end(), matrix_.valuePtr());
  factor_.factorize(matrix_);
  if (factor_.info() != Eigen::Success) return false;
  const auto diagonal = pose_part(*structure_, equations.diagonal);
  const auto& pivots = factor_.vectorD();
  const auto& place = factor_.permutationP().indices();
  for (Eigen::Index i = 0; i < pivots.size(); ++i) {
    if (!is_determined(pivots[place[i]], diagonal[i])) return false;
  }
  auto rhs = pose_part(*structure_, equations.rhs);
  rhs = factor_.solve(rhs).eval();
  return true;
}

}  // namespace lanefuse
