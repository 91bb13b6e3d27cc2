// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/landmark_roles.hpp"

#include <algorithm>
#include <vector>

namespace lanefuse {

namespace {

/// Whether a directed chain of edges leads from a vertex to a fixed one.
std::vector<bool> leading_to_fixed(const PoseGraph& graph) {
  std::vector<std::vector<VertexId>> measured_by(graph.vertices.size());
  for (const Edge& edge : graph.edges) measured_by[edge.to].push_back(edge.from);
  std::vector<bool> leading(graph.vertices.size(), false);
  std::vector<VertexId> open;
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    if (graph.vertices[v].fixed) open.push_back(v);
  }
  while (!open.empty()) {
    const VertexId v = open.back();
    open.pop_back();
    if (leading[v]) continue;
    leading[v] = true;
    open.insert(open.end(), measured_by[v].begin(), measured_by[v].end());
  }
  return leading;
}

/// Whether everyone who is not a pose is measured by one.
bool all_measured(const PoseGraph& graph, const std::vector<bool>& is_pose) {
  std::vector<bool> measured = is_pose;
  for (const Edge& edge : graph.edges) {
    if (is_pose[edge.from]) measured[edge.to] = true;
  }
  return std::find(measured.begin(), measured.end(), false) == measured.end();
}

}  // namespace

void tell_landmarks(PoseGraph& graph) {
  const std::vector<bool> is_pose = leading_to_fixed(graph);
  const bool plausible = all_measured(graph, is_pose);
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    graph.vertices[v].role = plausible && !is_pose[v] ? VertexRole::landmark : VertexRole::pose;
  }
}

}  // namespace lanefuse
