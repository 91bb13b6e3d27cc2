// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/elimination_order.hpp"

#include <algorithm>

#include "graph/ladder.hpp"

namespace lanefuse {

void EliminationOrder::compute(const PoseGraph& graph) {
  number_poses(graph);
  collect_adjacency(graph);
  begin_.assign(1, 0);
  neighbours_.clear();
  take_lone_landmarks(graph);
  take_ladders();
}

void EliminationOrder::number_poses(const PoseGraph& graph) {
  block_of_vertex_.assign(graph.vertices.size(), kHeld);
  landmarks_ = 0;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    if (graph.vertices[v].fixed || graph.vertices[v].role != VertexRole::landmark) continue;
    block_of_vertex_[v] = kUnnumbered;
    ++landmarks_;
  }
  blocks_ = landmarks_;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    if (!graph.vertices[v].fixed && graph.vertices[v].role == VertexRole::pose)
      block_of_vertex_[v] = blocks_++;
  }
}

void EliminationOrder::collect_adjacency(const PoseGraph& graph) {
  const auto each_neighbour = [&](auto&& visit) {
    for (const Edge& edge : graph.edges) {
      if (block(edge.from) == kHeld || block(edge.to) == kHeld) continue;
      if (is_free_landmark(edge.from)) visit(edge.from, edge.to);
      if (is_free_landmark(edge.to)) visit(edge.to, edge.from);
    }
  };
  adjacency_begin_.assign(graph.vertices.size() + 1, 0);
  each_neighbour([&](VertexId landmark, VertexId) { ++adjacency_begin_[landmark + 1]; });
  for (std::size_t v = 1; v < adjacency_begin_.size(); ++v) adjacency_begin_[v] += adjacency_begin_[v - 1];
  adjacency_.resize(adjacency_begin_.back());
  adjacency_end_.assign(adjacency_begin_.begin(), adjacency_begin_.end() - 1);
  each_neighbour([&](VertexId landmark, VertexId other) { adjacency_[adjacency_end_[landmark]++] = other; });
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    const auto first = adjacency_.begin() + static_cast<std::ptrdiff_t>(adjacency_begin_[v]);
    const auto last = adjacency_.begin() + static_cast<std::ptrdiff_t>(adjacency_end_[v]);
    if (!std::is_sorted(first, last)) std::sort(first, last);
    adjacency_end_[v] = static_cast<std::size_t>(std::unique(first, last) - adjacency_.begin());
  }
}

std::span<const VertexId> EliminationOrder::adjacent(VertexId landmark) const {
  return {adjacency_.data() + adjacency_begin_[landmark], adjacency_.data() + adjacency_end_[landmark]};
}

void EliminationOrder::take_lone_landmarks(const PoseGraph& graph) {
  ladder_vertices_.clear();
  std::uint32_t next = 0;
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    if (graph.vertices[v].fixed || graph.vertices[v].role != VertexRole::landmark) continue;
    const auto others = adjacent(v);
    const auto is_landmark = [&](VertexId other) {
      return graph.vertices[other].role == VertexRole::landmark;
    };
    if (std::any_of(others.begin(), others.end(), is_landmark)) {
      ladder_vertices_.push_back(v);
      continue;
    }
    for (const VertexId pose : others) neighbours_.push_back(block(pose));
    begin_.push_back(neighbours_.size());
    block_of_vertex_[v] = next++;
  }
}

void EliminationOrder::take_ladders() {
  std::vector<LadderNode> nodes(ladder_vertices_.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const VertexId other : adjacent(ladder_vertices_[i])) {
      if (!is_free_landmark(other)) {
        nodes[i].poses.push_back(block(other));
        continue;
      }
      const auto place = std::lower_bound(ladder_vertices_.begin(), ladder_vertices_.end(), other);
      nodes[i].ties.push_back(static_cast<std::uint32_t>(place - ladder_vertices_.begin()));
    }
  }
  const auto order = eliminate_ladder(nodes);
  auto next = static_cast<std::uint32_t>(begin_.size() - 1);
  for (const std::uint32_t node : order) block_of_vertex_[ladder_vertices_[node]] = next++;
  for (const std::uint32_t node : order) {
    const auto first = neighbours_.size();
    for (const std::uint32_t tie : nodes[node].ties) neighbours_.push_back(block(ladder_vertices_[tie]));
    std::sort(neighbours_.begin() + static_cast<std::ptrdiff_t>(first), neighbours_.end());
    neighbours_.insert(neighbours_.end(), nodes[node].poses.begin(), nodes[node].poses.end());
    begin_.push_back(neighbours_.size());
  }
}

}  // namespace lanefuse
