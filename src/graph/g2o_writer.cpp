// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "graph/g2o.hpp"

namespace lanefuse {

namespace {

std::int64_t vertex_id(const G2oGraph& g, std::size_t vertex) {
  return vertex < g.vertex_ids.size() ? g.vertex_ids[vertex] : static_cast<std::int64_t>(vertex);
}

std::int64_t switch_id(const G2oGraph& g, std::size_t index) {
  return index < g.switch_ids.size() ? g.switch_ids[index]
                                     : static_cast<std::int64_t>(g.graph.vertices.size() + index);
}

std::string edge_line(const G2oGraph& g, const Edge& edge) {
  const bool switched = edge.switch_index != kNoSwitch;
  std::string line = fmt::format("EDGE_SE2{} {} {}", switched ? "_SWITCHABLE" : "", vertex_id(g, edge.from),
                                 vertex_id(g, edge.to));
  if (switched) line += fmt::format(" {}", switch_id(g, edge.switch_index));
  line += fmt::format(" {} {} {}", edge.measurement.x, edge.measurement.y, edge.measurement.heading);
  for (int r = 0; r < 3; ++r) {
    for (int c = r; c < 3; ++c) line += fmt::format(" {}", edge.information(r, c));
  }
  return line + '\n';
}

}  // namespace

void number_new_switches(G2oGraph& g) {
  std::int64_t next = static_cast<std::int64_t>(g.graph.vertices.size());
  for (const std::int64_t id : g.vertex_ids) next = std::max(next, id + 1);
  for (const std::int64_t id : g.switch_ids) next = std::max(next, id + 1);
  while (g.switch_ids.size() < g.graph.switches.size()) g.switch_ids.push_back(next++);
}

void write_g2o(std::ostream& out, const G2oGraph& g) {
  const PoseGraph& graph = g.graph;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    const Pose2& pose = graph.vertices[v].pose;
    out << fmt::format("VERTEX_SE2 {} {} {} {}\n", vertex_id(g, v), pose.x, pose.y, pose.heading);
  }
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    if (graph.vertices[v].fixed) out << fmt::format("FIX {}\n", vertex_id(g, v));
  }
  for (std::size_t k = 0; k < graph.switches.size(); ++k) {
    out << fmt::format("VERTEX_SWITCH {} {}\n", switch_id(g, k), graph.switches[k].value);
  }
  for (const Edge& edge : graph.edges) out << edge_line(g, edge);
  for (std::size_t k = 0; k < graph.switches.size(); ++k) {
    out << fmt::format("EDGE_SWITCH_PRIOR {} 1 {}\n", switch_id(g, k), graph.switches[k].prior);
  }
}

}  // namespace lanefuse
