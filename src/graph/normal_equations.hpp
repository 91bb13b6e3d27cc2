// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graph/block_structure.hpp"
#include "graph/edge_terms.hpp"

namespace lanefuse {

/// The Gauss-Newton equations H step = rhs of a graph at one place: H = sum A' w Omega A, rhs = -sum A' w
/// Omega e.
class NormalEquations {
 public:
  /// Finds the place of every edge's blocks; the structure must outlive what follows.
  void prepare(const EdgeTerms& terms, const EliminationOrder& order, const BlockStructure& structure,
               const WeakTerms& weak = {});

  /// Sums up the equations at these places, where `terms` was evaluated last, and adds `damping` times H's
  /// diagonal.
  void assemble(const EdgeTerms& terms, const std::vector<Placed>& places, double damping);

  std::vector<double> values;  ///< H, laid out by BlockStructure
  Eigen::VectorXd rhs;         ///< three numbers a block
  Eigen::VectorXd diagonal;    ///< H's diagonal, damping included

 private:
  static constexpr std::size_t kNowhere = ~std::size_t{0};

  struct Target {
    std::size_t from = 0;   ///< value where the block of `from` with itself begins
    std::size_t to = 0;     ///< the same of `to`
    std::size_t cross = 0;  ///< the same of both together, or kNowhere
    std::size_t from_stride = 0;
    std::size_t to_stride = 0;
    std::uint32_t from_block = kHeld;
    std::uint32_t to_block = kHeld;
  };

  void add(const Target& target, const Symmetric3& information, const Eigen::Vector3d& pull,
           const Eigen::Vector2d& lever);
  void add_cross(const Target& target, const Eigen::Matrix3d& block);
  void damp(double damping);

  std::vector<Target> targets_;
  const BlockStructure* structure_ = nullptr;
};

}  // namespace lanefuse
