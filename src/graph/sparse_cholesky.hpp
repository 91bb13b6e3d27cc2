// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "graph/supernodes.hpp"

namespace lanefuse {

/// Cholesky factorisation H = L L' of a sparse symmetric matrix of 3x3 blocks, panel by panel: each panel is
/// factored as a dense piece and subtracts its share from the later ones.
class SparseCholesky {
 public:
  /// Lays the factor out for a shape. All that follows counts blocks by turns: `supernodes` tells whose turn
  /// is when, and must outlive it.
  void prepare(const Supernodes& supernodes);

  /// The numbers of H, lower triangle, to be filled in before `factor`: where `supernodes.locate` says; one
  /// scalar column is its panel's height away from the next.
  [[nodiscard]] std::vector<double>& values() { return values_; }

  /// Puts L in place of H. False if a pivot is not positive.
  bool factor();

  /// L's own block of a turn: times its transpose, it is what was left of H's when its turn came.
  [[nodiscard]] Eigen::Matrix3d own_block(std::uint32_t turn) const;

  /// Puts H^-1 x in place of x.
  void solve(Eigen::VectorXd& x) const;

 private:
  using Panel = Supernodes::Panel;
  struct Run {
    std::size_t source = 0;  ///< scalar row of the panel that gives
    std::size_t target = 0;  ///< scalar row of the panel that takes
    std::size_t length = 0;
  };

  void update_later(const Panel& panel);
  void find_runs(const Panel& panel, std::uint32_t first, const Panel& target);
  void subtract_directly(const Panel& panel, std::size_t row, std::size_t rows, double* target,
                         std::size_t stride);
  void subtract_product(const Panel& panel, std::size_t row, std::size_t rows, double* target,
                        std::size_t stride);

  const Supernodes* supernodes_ = nullptr;
  std::vector<double> values_;
  std::vector<Run> runs_;        ///< scratch
  std::vector<double> product_;  ///< scratch
};

}  // namespace lanefuse
