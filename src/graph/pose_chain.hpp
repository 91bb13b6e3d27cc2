// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "graph/window_system.hpp"

namespace lanefuse {

/// The steps from pose to pose: a block-tridiagonal part of the normal equations, and the preconditioner that
/// is made of it. The newest pose is held. Vectors are by pose, in the order of the graph's slots.
class PoseChain {
 public:
  /// Takes the steps at the places in `system` and adds to its `pose_rhs`. Returns their cost.
  double linearize(const WindowGraph& graph, WindowSystem& system);

  /// Their cost alone.
  [[nodiscard]] double cost(const WindowGraph& graph, const WindowSystem& system) const;

  /// Factorises the chain with the diagonal that the landmarks leave (`reduced_first`, `reduced_rest`). False
  /// if a pose is undetermined.
  bool factorise(const WindowGraph& graph, const WindowSystem& system);

  /// product += chain * p.
  void add_product(const WindowGraph& graph, std::span<const Quad> p, std::span<Quad> product) const;

  /// z = M^-1 r, zero at the held pose.
  void precondition(const WindowGraph& graph, std::span<const Quad> r, std::span<Quad> z) const;

 private:
  // By place in the chain; [k] of `next_` is the block between k and k + 1.
  std::vector<Eigen::Matrix3d> diagonal_, next_;
  std::vector<Eigen::Matrix3d> inverse_, gain_;  ///< factors: M_k^-1 and M_k^-1 next_k
};

}  // namespace lanefuse
