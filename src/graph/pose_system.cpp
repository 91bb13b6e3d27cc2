// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/pose_system.hpp"

#include <algorithm>

#include <Eigen/Cholesky>

#include "graph/determinacy.hpp"

namespace lanefuse {

void PoseSystem::prepare(const BlockStructure& structure) {
  structure_ = &structure;
  if (structure.poses_are_dense()) return;
  fill_pattern();
  factor_.prepare(supernodes_);
  place_blocks();
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

void PoseSystem::fill_pattern() {
  const std::uint32_t landmarks = structure_->landmarks();
  std::vector<std::vector<std::uint32_t>> neighbours(structure_->poses());
  for (std::uint32_t pose = 0; pose < neighbours.size(); ++pose) {
    for (const std::uint32_t row : structure_->rows(landmarks + pose)) {
      if (row == landmarks + pose) continue;
      neighbours[pose].push_back(row - landmarks);
      neighbours[row - landmarks].push_back(pose);
    }
  }
  supernodes_.analyse(neighbours);
}

void PoseSystem::place_blocks() {
  const std::uint32_t landmarks = structure_->landmarks();
  const auto& turns = supernodes_.turns();
  blocks_.clear();
  for (std::uint32_t pose = 0; pose < structure_->poses(); ++pose) {
    const BlockStructure::Column& column = structure_->column(landmarks + pose);
    std::size_t source = column.values;
    for (const std::uint32_t row : structure_->rows(landmarks + pose)) {
      const std::uint32_t a = turns[pose], b = turns[row - landmarks];
      const std::uint32_t first = std::min(a, b);
      const std::size_t stride = supernodes_.panels()[supernodes_.panel_of(first)].height();
      const std::size_t target = supernodes_.locate(std::max(a, b), first);
      blocks_.push_back({source, target, column.stride, a <= b ? 1 : stride, a <= b ? stride : 1});
      source += 3;
    }
  }
}

bool PoseSystem::solve_sparse(NormalEquations& equations) {
  std::vector<double>& values = factor_.values();
  std::fill(values.begin(), values.end(), 0.0);
  for (const BlockPlace& block : blocks_) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r < 3; ++r) {
        values[block.target + r * block.row_stride + c * block.column_stride] =
            equations.values[block.source + c * block.source_stride + r];
      }
    }
  }
  if (!factor_.factor() || !all_determined(equations)) return false;
  const auto& turns = supernodes_.turns();
  auto rhs = equations.rhs.tail(3 * static_cast<Eigen::Index>(turns.size()));
  rhs_.resize(rhs.size());
  for (std::uint32_t pose = 0; pose < turns.size(); ++pose) {
    rhs_.segment<3>(3 * turns[pose]) = rhs.segment<3>(3 * pose);
  }
  factor_.solve(rhs_);
  for (std::uint32_t pose = 0; pose < turns.size(); ++pose) {
    rhs.segment<3>(3 * pose) = rhs_.segment<3>(3 * turns[pose]);
  }
  return true;
}

bool PoseSystem::all_determined(const NormalEquations& equations) const {
  const auto& turns = supernodes_.turns();
  const auto diagonal = equations.diagonal.tail(3 * static_cast<Eigen::Index>(turns.size()));
  for (std::uint32_t pose = 0; pose < turns.size(); ++pose) {
    const Eigen::Matrix3d root = factor_.own_block(turns[pose]);
    if (!is_determined(root * root.transpose(), diagonal.segment<3>(3 * pose))) return false;
  }
  return true;
}

}  // namespace lanefuse
