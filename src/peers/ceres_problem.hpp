// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <ceres/problem.h>

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// A graph as a problem for Ceres, kept for as long as only the vertices move.
class CeresProblem {
 public:
  CeresProblem(const PoseGraph& graph, SwitchForm form);

  /// Whether this graph differs from the one of this problem in the places of its vertices alone.
  [[nodiscard]] bool fits(const PoseGraph& graph, SwitchForm form) const;

  void read_places(const PoseGraph& graph);
  void write_places(PoseGraph& graph) const;  ///< of all free vertices; switches at their best there

  [[nodiscard]] ceres::Problem& problem() { return *problem_; }
  /// The free vertices that an edge uses, in two groups: landmarks without a tie to another of the group, and
  /// all the others. What Ceres eliminates first.
  [[nodiscard]] const std::array<std::vector<double*>, 2>& groups() const { return groups_; }

 private:
  void add_edges(SwitchForm form);
  void hold_and_group();

  PoseGraph graph_;  ///< as it was when the problem was built
  SwitchForm form_;
  std::vector<std::array<double, 3>> places_;
  std::unique_ptr<ceres::Problem> problem_;
  std::array<std::vector<double*>, 2> groups_;
};

}  // namespace lanefuse
