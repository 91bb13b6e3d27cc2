// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/pose_system.hpp"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>

#include "graph/determinacy.hpp"

namespace lanefuse {

void PoseSystem::prepare(const BlockStructure& structure) {
  structure_ = &structure;
  if (structure.poses_are_dense()) return;
  order_poses();
  fill_pattern();
  factor_.analyzePattern(matrix_);
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
  const auto diagonal = equations.diagonal.tail(side);
  for (Eigen::Index i = 0; i < side; i += 3) {
    const Eigen::Matrix3d root = matrix.block<3, 3>(i, i).triangularView<Eigen::Lower>();
    if (!is_determined(root * root.transpose(), diagonal.segment<3>(i))) return false;
  }
  auto rhs = equations.rhs.tail(side);
  factor.solveInPlace(rhs);
  return true;
}

void PoseSystem::order_poses() {
  const auto poses = static_cast<int>(structure_->poses());
  std::vector<Eigen::Triplet<double>> ties;
  for (std::uint32_t pose = 0; pose < structure_->poses(); ++pose) {
    for (const std::uint32_t row : structure_->rows(structure_->landmarks() + pose)) {
      ties.emplace_back(static_cast<int>(row - structure_->landmarks()), static_cast<int>(pose), 1.0);
    }
  }
  SparseMatrix pattern(poses, poses);
  pattern.setFromTriplets(ties.begin(), ties.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> pose_of_turn;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), pose_of_turn);
  turn_of_pose_.resize(structure_->poses());
  for (int turn = 0; turn < poses; ++turn) {
    turn_of_pose_[pose_of_turn.indices()[turn]] = static_cast<std::uint32_t>(turn);
  }
}

void PoseSystem::fill_pattern() {
  // The matrix is first filled with the places of its numbers: how it arranges them is the map.
  std::vector<Eigen::Triplet<double>> places;
  for (std::uint32_t pose = 0; pose < structure_->poses(); ++pose) {
    const BlockStructure::Column& column = structure_->column(structure_->landmarks() + pose);
    const auto rows = structure_->rows(structure_->landmarks() + pose);
    for (std::uint32_t k = 0; k < 9 * column.count; ++k) {
      const std::uint32_t c = k / (3 * column.count), r = k % (3 * column.count);
      const std::uint32_t row = 3 * turn_of_pose_[rows[r / 3] - structure_->landmarks()] + r % 3;
      const std::uint32_t col = 3 * turn_of_pose_[pose] + c;
      if (r < 3 && row < col) continue;  // the upper half of the pose's own block
      places.emplace_back(static_cast<int>(std::max(row, col)), static_cast<int>(std::min(row, col)),
                          static_cast<double>(column.values + c * column.stride + r));
    }
  }
  const auto side = static_cast<int>(3 * structure_->poses());
  matrix_.resize(side, side);
  matrix_.setFromTriplets(places.begin(), places.end());
  source_.assign(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros());
}

bool PoseSystem::solve_sparse(NormalEquations& equations) {
  std::transform(source_.begin(), source_.end(), matrix_.valuePtr(),
                 [&](std::size_t place) { return equations.values[place]; });
  factor_.factorize(matrix_);
  if (factor_.info() != Eigen::Success || !all_determined(equations)) return false;
  auto rhs = equations.rhs.tail(matrix_.cols());
  rhs_.resize(rhs.size());
  for (std::uint32_t pose = 0; pose < structure_->poses(); ++pose) {
    rhs_.segment<3>(3 * turn_of_pose_[pose]) = rhs.segment<3>(3 * pose);
  }
  rhs_ = factor_.solve(rhs_).eval();
  for (std::uint32_t pose = 0; pose < structure_->poses(); ++pose) {
    rhs.segment<3>(3 * pose) = rhs_.segment<3>(3 * turn_of_pose_[pose]);
  }
  return true;
}

bool PoseSystem::all_determined(const NormalEquations& equations) const {
  const auto lower = factor_.matrixL();
  const auto& factor = lower.nestedExpression();
  const Eigen::VectorXd pivots = factor_.vectorD();
  const auto diagonal = equations.diagonal.tail(matrix_.cols());
  for (std::uint32_t pose = 0; pose < structure_->poses(); ++pose) {
    const Eigen::Index first = 3 * turn_of_pose_[pose];
    Eigen::Matrix3d own = Eigen::Matrix3d::Identity();
    own(1, 0) = factor.coeff(first + 1, first);
    own(2, 0) = factor.coeff(first + 2, first);
    own(2, 1) = factor.coeff(first + 2, first + 1);
    const Eigen::Matrix3d remaining = own * pivots.segment<3>(first).asDiagonal() * own.transpose();
    if (!is_determined(remaining, diagonal.segment<3>(3 * pose))) return false;
  }
  return true;
}

}  // namespace lanefuse
