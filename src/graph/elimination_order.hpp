// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/pose_graph.hpp"

namespace lanefuse {

inline constexpr std::uint32_t kHeld = 0xffffffff;

/// Which vertex is eliminated when, and onto whom.
///
/// Every free vertex is a block of three unknowns. Landmarks come first: those without edges to other
/// landmarks, then the ladders (landmarks tied to each other), by least degree. The free poses follow in the
/// graph's order; the pose system orders itself.
class EliminationOrder {
 public:
  void compute(const PoseGraph& graph);

  /// The block of a vertex, or kHeld if it is fixed.
  [[nodiscard]] std::uint32_t block(VertexId vertex) const { return block_of_vertex_[vertex]; }
  [[nodiscard]] std::uint32_t landmarks() const { return landmarks_; }  ///< blocks [0, landmarks())
  [[nodiscard]] std::uint32_t blocks() const { return blocks_; }
  /// The later blocks that a landmark is tied to when its turn comes, with the fill of those before it;
  /// ascending.
  [[nodiscard]] std::span<const std::uint32_t> neighbours(std::uint32_t landmark) const {
    return {neighbours_.data() + begin_[landmark], neighbours_.data() + begin_[landmark + 1]};
  }

 private:
  void number_poses(const PoseGraph& graph);
  void collect_adjacency(const PoseGraph& graph);
  void take_lone_landmarks(const PoseGraph& graph);
  void take_ladders();
  [[nodiscard]] std::span<const VertexId> adjacent(VertexId landmark) const;
  [[nodiscard]] bool is_free_landmark(VertexId vertex) const {
    return block_of_vertex_[vertex] == kUnnumbered;
  }

  static constexpr std::uint32_t kUnnumbered = 0xfffffffe;  ///< a free landmark whose turn is not yet known

  std::vector<std::uint32_t> block_of_vertex_;
  std::uint32_t landmarks_ = 0;
  std::uint32_t blocks_ = 0;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> neighbours_;

  // The free vertices that share an edge with a free landmark, ascending and once each.
  std::vector<std::size_t> adjacency_begin_;
  std::vector<std::size_t> adjacency_end_;
  std::vector<VertexId> adjacency_;
  std::vector<VertexId> ladder_vertices_;
};

}  // namespace lanefuse
