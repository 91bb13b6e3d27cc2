// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "graph/toro.hpp"

namespace lanefuse {

namespace {

std::int64_t id_of(const G2oGraph& g, std::size_t vertex) {
  return vertex < g.vertex_ids.size() ? g.vertex_ids[vertex] : static_cast<std::int64_t>(vertex);
}

/// Whether the vertex that readers hold, where no line says which, is the only one that is held.
bool holds_the_lowest_alone(const G2oGraph& g) {
  std::size_t lowest = 0, held = 0;
  for (std::size_t v = 0; v < g.graph.vertices.size(); ++v) {
    if (id_of(g, v) < id_of(g, lowest)) lowest = v;
    held += g.graph.vertices[v].fixed ? 1 : 0;
  }
  return held == 1 && g.graph.vertices[lowest].fixed;
}

}  // namespace

void write_toro(std::ostream& out, const G2oGraph& g) {
  for (std::size_t v = 0; v < g.graph.vertices.size(); ++v) {
    const Pose2& pose = g.graph.vertices[v].pose;
    out << fmt::format("VERTEX2 {} {} {} {}\n", id_of(g, v), pose.x, pose.y, pose.heading);
  }
  for (const Edge& edge : g.graph.edges) {
    const Pose2& z = edge.measurement;
    const Eigen::Matrix3d& m = edge.information;
    out << fmt::format("EDGE2 {} {} {} {} {} {} {} {} {} {} {}\n", id_of(g, edge.from), id_of(g, edge.to),
                       z.x, z.y, z.heading, m(0, 0), m(0, 1), m(1, 1), m(2, 2), m(0, 2), m(1, 2));
  }
}

std::vector<std::string> lost_in_toro(const G2oGraph& g) {
  std::vector<std::string> lost;
  const auto switched = std::count_if(g.graph.edges.begin(), g.graph.edges.end(),
                                      [](const Edge& edge) { return edge.switch_index != kNoSwitch; });
  if (switched > 0) {
    lost.push_back(fmt::format("{} switchable edges became plain ones, without switch and prior", switched));
  }
  if (!holds_the_lowest_alone(g)) lost.emplace_back("which vertices are held: readers hold the lowest");
  return lost;
}

}  // namespace lanefuse
