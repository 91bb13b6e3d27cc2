// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "graph/pose_graph.hpp"
#include "graph/window_system.hpp"

namespace lanefuse {

/// The block D of the landmarks that are tied to each other, and its factors. Ties are short beside the road,
/// so eliminating from one end of the road to the other leaves little fill, however ladders are joined.
class TiedLandmarks {
 public:
  /// Appends the tied landmarks to `system.runs` in the order of elimination, along the heading of the newest
  /// pose, and finds the pattern of the factors.
  void prepare(const WindowGraph& graph, WindowSystem& system);

  /// Adds all ties at their best switches to D, which is the observations' part in `system.information`, and
  /// to `landmark_rhs`. Returns their cost.
  double linearize(const WindowGraph& graph, SwitchForm form, WindowSystem& system);

  /// Their cost alone, at the places in `system`.
  double cost(const WindowGraph& graph, SwitchForm form, const WindowSystem& system);

  /// Factorises D; false if it leaves a landmark undetermined.
  bool factorise();

  /// Solves D y = v for the tied part of vectors by landmark.
  void solve(std::span<Quad> by_landmark) const;

  /// Of the whole of D, the block of a landmark: before factorise().
  [[nodiscard]] const Eigen::Matrix3d& diagonal(std::size_t node) const { return diagonal_[node]; }
  [[nodiscard]] std::size_t size() const { return diagonal_.size(); }

  /// The best values of the switches at the last linearisation or cost, by tie.
  void write_switches(WindowGraph& graph) const;

 private:
  struct Active {
    WindowGraph::Id tie;
    std::uint32_t from, to;  ///< nodes
    std::uint32_t block;     ///< of off_diagonal_
  };
  struct TieError;
  [[nodiscard]] TieError error(const WindowGraph& graph, const Active& active, SwitchForm form,
                               const WindowSystem& system) const;
  void eliminate(std::uint32_t k);
  void order(const WindowGraph& graph, WindowSystem& system);
  void find_pattern(const WindowGraph& graph);
  void find_ties(const WindowGraph& graph);
  [[nodiscard]] std::uint32_t find_block(std::uint32_t column, std::uint32_t row) const;

  std::size_t untied_ = 0;
  std::vector<std::pair<double, WindowGraph::Id>> along_;  ///< scratch: tied landmarks by their way ahead
  std::vector<std::uint32_t> node_of_;                     ///< by landmark
  std::vector<WindowGraph::Id> landmark_of_;               ///< by node
  std::vector<Active> active_;
  std::vector<double> switch_values_;  ///< beside active_

  // Column k of the factors: the later nodes rows_[begin_[k]..begin_[k+1]), ascending.
  std::vector<std::uint32_t> begin_, rows_;
  std::vector<std::uint32_t> first_child_, next_sibling_, mark_;

  std::vector<Eigen::Matrix3d> diagonal_, inverse_;
  std::vector<Eigen::Vector3d> scale_;         ///< D's diagonal before elimination
  std::vector<Eigen::Matrix3d> off_diagonal_;  ///< D(k, i), after factorise() D_k^-1 D(k, i)
  std::vector<Eigen::Matrix3d> eliminated_;    ///< scratch: the same of one column
};

}  // namespace lanefuse
