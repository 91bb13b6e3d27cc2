// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/false_loops.hpp"

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "graph/loops.hpp"

namespace lanefuse {

namespace {

std::vector<VertexId> poses_of(const PoseGraph& graph) {
  std::vector<VertexId> poses;
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    if (graph.vertices[v].role == VertexRole::pose) poses.push_back(v);
  }
  return poses;
}

/// The diagonal of the box that holds all poses [m].
double extent(const PoseGraph& graph, const std::vector<VertexId>& poses) {
  Eigen::Vector2d low = graph.vertices[poses.front()].pose.position(), high = low;
  for (const VertexId v : poses) {
    low = low.cwiseMin(graph.vertices[v].pose.position());
    high = high.cwiseMax(graph.vertices[v].pose.position());
  }
  return (high - low).norm();
}

/// One of these, each as likely as the others.
template <typename Thing>
const Thing& any_of(const std::vector<Thing>& things, Random& random) {
  return things[static_cast<std::size_t>(random.uniform() * static_cast<double>(things.size()))];
}

Pose2 shaken(const Pose2& pose, Random& random) {
  const double length = std::max(pose.position().norm(), 0.1);
  return {pose.x + random.normal(0.1 * length), pose.y + random.normal(0.1 * length),
          wrap_angle(pose.heading + random.normal(0.1))};
}

}  // namespace

void add_false_loops(PoseGraph& graph, std::size_t count, Random& random) {
  constexpr int kMostTries = 1000;
  std::vector<Edge> loops;
  std::copy_if(graph.edges.begin(), graph.edges.end(), std::back_inserter(loops),
               [&](const Edge& edge) { return is_loop(graph, edge); });
  if (loops.empty()) throw input_error("the graph", "has no loop closure that a false one could be like");
  const std::vector<VertexId> poses = poses_of(graph);
  const double far = extent(graph, poses) / 4;
  for (std::size_t i = 0; i < count; ++i) {
    VertexId from = 0, to = 0;
    for (int tries = 0; from == to; ++tries) {
      if (tries == kMostTries) throw input_error("the graph", "has too few poses that are far apart");
      from = any_of(poses, random);
      to = any_of(poses, random);
      const double apart = (graph.vertices[from].pose.position() - graph.vertices[to].pose.position()).norm();
      if (!(apart > 0 && apart >= far)) from = to;
    }
    const Edge& like = any_of(loops, random);
    graph.edges.push_back({from, to, shaken(like.measurement, random), like.information, kNoSwitch});
  }
}

}  // namespace lanefuse
