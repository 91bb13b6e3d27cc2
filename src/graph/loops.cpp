// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/loops.hpp"

namespace lanefuse {

bool is_loop(const PoseGraph& graph, const Edge& edge) {
  const bool between_poses =
      graph.vertices[edge.from].role == VertexRole::pose && graph.vertices[edge.to].role == VertexRole::pose;
  return between_poses && edge.from + 1 != edge.to && edge.to + 1 != edge.from;
}

void make_loops_switchable(PoseGraph& graph, double prior) {
  for (Edge& edge : graph.edges) {
    if (edge.switch_index != kNoSwitch || !is_loop(graph, edge)) continue;
    edge.switch_index = static_cast<std::uint32_t>(graph.switches.size());
    graph.switches.push_back({prior, 1});
  }
}

}  // namespace lanefuse
