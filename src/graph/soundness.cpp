// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/soundness.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace lanefuse {

namespace {

bool is_sound(const PoseGraph& graph, const Edge& edge) {
  return edge.from < graph.vertices.size() && edge.to < graph.vertices.size() && edge.from != edge.to &&
         (edge.switch_index == kNoSwitch || edge.switch_index < graph.switches.size());
}

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

bool all_finite(const PoseGraph& graph) {
  return std::all_of(graph.vertices.begin(), graph.vertices.end(),
                     [](const Vertex& v) { return is_finite(v.pose); }) &&
         std::all_of(graph.edges.begin(), graph.edges.end(),
                     [](const Edge& e) { return is_finite(e.measurement) && e.information.allFinite(); }) &&
         std::all_of(graph.switches.begin(), graph.switches.end(),
                     [](const Switch& s) { return std::isfinite(s.prior); });
}

/// Whether a chain of edges joins every vertex to a fixed one.
bool all_held(const PoseGraph& graph) {
  std::vector<VertexId> parent(graph.vertices.size());
  std::iota(parent.begin(), parent.end(), VertexId{0});
  const auto root = [&](VertexId v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Edge& edge : graph.edges) parent[root(edge.from)] = root(edge.to);
  std::vector<bool> held(graph.vertices.size(), false);
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    if (graph.vertices[v].fixed) held[root(v)] = true;
  }
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    if (!held[root(v)]) return false;
  }
  return true;
}

}  // namespace

std::optional<SolveStatus> find_fault(const PoseGraph& graph) {
  const auto sound = [&](const Edge& edge) { return is_sound(graph, edge); };
  if (!std::all_of(graph.edges.begin(), graph.edges.end(), sound)) return SolveStatus::bad_edge;
  if (!all_finite(graph)) return SolveStatus::not_finite;
  if (std::any_of(graph.switches.begin(), graph.switches.end(),
                  [](const Switch& s) { return s.prior <= 0; })) {
    return SolveStatus::bad_edge;
  }
  if (std::none_of(graph.vertices.begin(), graph.vertices.end(), [](const Vertex& v) { return v.fixed; })) {
    return SolveStatus::no_fixed_vertex;
  }
  if (!all_held(graph)) return SolveStatus::singular;
  return std::nullopt;
}

}  // namespace lanefuse
