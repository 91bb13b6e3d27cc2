// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/window_conversion.hpp"

#include <cmath>
#include <cstdint>

namespace lanefuse {

namespace {

using Id = WindowGraph::Id;

Eigen::Matrix3d in_frame_of_measurement(const Symmetric3& information, double heading) {
  const Symmetric3 m = turned(information, std::cos(heading), -std::sin(heading));
  return (Eigen::Matrix3d() << m.xx, m.xy, m.xh, m.xy, m.yy, m.yh, m.xh, m.yh, m.hh).finished();
}

Eigen::Matrix3d in_frame_of_measurement(const WindowGraph::Block& block, std::size_t place) {
  const Symmetric3 information{
      block.mean[place] + block.half[place], block.cross[place], block.mean[place] - block.half[place], 0, 0,
      block.heading_information[place]};
  return in_frame_of_measurement(information, block.heading[place]);
}

void copy_observations(const WindowGraph& window, Id landmark, VertexId vertex,
                       const std::vector<VertexId>& vertex_of_pose, std::vector<Edge>& edges) {
  for (Id id = window.first_block(landmark); id != WindowGraph::kNone; id = window.block(id).next) {
    const WindowGraph::Block& block = window.block(id);
    for (std::size_t k = 0; k < 4; ++k) {
      if (block.pose[k] == WindowGraph::kNowhere) continue;
      edges.push_back({vertex_of_pose[block.pose[k]],
                       vertex,
                       {block.x[k], block.y[k], block.heading[k]},
                       in_frame_of_measurement(block, k)});
    }
  }
}

void copy_ties(const WindowGraph& window, const std::vector<VertexId>& vertex_of_landmark, PoseGraph& graph) {
  for (Id id = 0; id < window.tie_slots(); ++id) {
    if (!window.is_tie(id)) continue;
    const WindowGraph::Tie& tie = window.tie(id);
    Edge edge{vertex_of_landmark[tie.from], vertex_of_landmark[tie.to], tie.measurement,
              in_frame_of_measurement(tie.information, tie.measurement.heading)};
    if (tie.switch_prior > 0) {
      edge.switch_index = static_cast<std::uint32_t>(graph.switches.size());
      graph.switches.push_back({tie.switch_prior, tie.switch_value});
    }
    graph.edges.push_back(edge);
  }
}

/// Puts the poses of a graph into the window in the order of their steps; false if they are no chain that
/// ends at the one fixed vertex.
bool take_chain(const PoseGraph& graph, WindowOfGraph& out) {
  const std::size_t none = graph.edges.size();
  std::vector<std::size_t> step_to(graph.vertices.size(), none);
  VertexId newest = 0;
  std::size_t poses = 0;
  std::size_t fixed = 0;
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    const bool is_pose = graph.vertices[v].role == VertexRole::pose;
    if (is_pose) ++poses;
    if (!graph.vertices[v].fixed) continue;
    if (!is_pose) return false;
    newest = v;
    ++fixed;
  }
  if (fixed != 1) return false;
  std::size_t steps = 0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const Edge& edge = graph.edges[e];
    const bool is_step = graph.vertices[edge.from].role == VertexRole::pose &&
                         graph.vertices[edge.to].role == VertexRole::pose;
    if (!is_step) continue;
    if (step_to[edge.to] != none || edge.switch_index != kNoSwitch) return false;
    step_to[edge.to] = e;
    ++steps;
  }
  if (steps + 1 != poses) return false;
  std::vector<std::size_t> backwards;
  for (VertexId v = newest; step_to[v] != none && backwards.size() < steps; v = graph.edges[step_to[v]].from)
    backwards.push_back(step_to[v]);
  if (backwards.size() != steps) return false;
  const VertexId oldest = steps == 0 ? newest : graph.edges[backwards.back()].from;
  out.vertices[oldest] = out.window.append_pose(graph.vertices[oldest].pose, {}, Eigen::Matrix3d::Zero());
  for (std::size_t k = steps; k-- > 0;) {
    const Edge& edge = graph.edges[backwards[k]];
    out.vertices[edge.to] =
        out.window.append_pose(graph.vertices[edge.to].pose, edge.measurement, edge.information);
  }
  return true;
}

bool take_observation(const Edge& edge, std::uint64_t number, WindowOfGraph& out) {
  const Eigen::Matrix3d& m = edge.information;
  if (m(0, 2) != 0 || m(1, 2) != 0 || edge.switch_index != kNoSwitch) return false;
  out.window.observe(out.vertices[edge.from], out.vertices[edge.to], edge.measurement,
                     {m(0, 0), m(0, 1), m(1, 1), m(2, 2)}, number);
  return true;
}

bool take_tie(const PoseGraph& graph, const Edge& edge, std::uint32_t number, WindowOfGraph& out) {
  WindowGraph::Tie tie;
  tie.from = out.vertices[edge.from];
  tie.to = out.vertices[edge.to];
  tie.measurement = edge.measurement;
  tie.kind = number;
  if (edge.switch_index != kNoSwitch) tie.switch_prior = graph.switches[edge.switch_index].prior;
  const Id id = out.window.add_tie(tie, edge.information, false);
  if (edge.switch_index == kNoSwitch) return true;
  if (out.switches[edge.switch_index] != WindowGraph::kNone) return false;  // two edges share a switch
  out.switches[edge.switch_index] = id;
  return true;
}

}  // namespace

void copy(const WindowGraph& window, PoseGraph& graph) {
  graph.vertices.clear();
  graph.edges.clear();
  graph.switches.clear();
  std::vector<VertexId> vertex_of_pose(window.pose_slots());
  const auto chain = window.chain();
  for (std::size_t k = 0; k < chain.size(); ++k) {
    vertex_of_pose[chain[k]] = static_cast<VertexId>(k);
    graph.vertices.push_back({window.pose(chain[k]), VertexRole::pose, k + 1 == chain.size()});
    if (k == 0) continue;
    const WindowGraph::Step& step = window.steps()[k];
    graph.edges.push_back({static_cast<VertexId>(k - 1), static_cast<VertexId>(k), step.measurement,
                           in_frame_of_measurement(step.information, step.measurement.heading)});
  }
  std::vector<VertexId> vertex_of_landmark(window.landmark_slots());
  for (Id id = 0; id < window.landmark_slots(); ++id) {
    if (!window.is_alive(id)) continue;
    vertex_of_landmark[id] = static_cast<VertexId>(graph.vertices.size());
    graph.vertices.push_back({window.landmark(id), VertexRole::landmark, false});
    copy_observations(window, id, vertex_of_landmark[id], vertex_of_pose, graph.edges);
  }
  copy_ties(window, vertex_of_landmark, graph);
}

void take_places(const PoseGraph& graph, WindowGraph& window) {
  std::size_t v = 0;
  for (const Id id : window.chain()) window.place_pose(id, graph.vertices[v++].pose);
  for (Id id = 0; id < window.landmark_slots(); ++id) {
    if (window.is_alive(id)) window.place_landmark(id, graph.vertices[v++].pose);
  }
  std::size_t s = 0;
  for (Id id = 0; id < window.tie_slots(); ++id) {
    if (window.is_tie(id) && window.tie(id).switch_prior > 0)
      window.set_switch(id, graph.switches[s++].value);
  }
}

bool to_window(const PoseGraph& graph, WindowOfGraph& out) {
  out.window.clear();
  out.vertices.assign(graph.vertices.size(), WindowGraph::kNone);
  out.switches.assign(graph.switches.size(), WindowGraph::kNone);
  if (!take_chain(graph, out)) return false;
  const auto is_pose = [&](VertexId v) { return graph.vertices[v].role == VertexRole::pose; };
  for (VertexId v = 0; v < graph.vertices.size(); ++v) {
    if (!is_pose(v)) out.vertices[v] = out.window.add_landmark(graph.vertices[v].pose);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const Edge& edge = graph.edges[e];
    if (is_pose(edge.from) && is_pose(edge.to)) continue;
    if (is_pose(edge.to)) return false;  // nobody is observed by a landmark
    const bool fits = is_pose(edge.from) ? take_observation(edge, e, out)
                                         : take_tie(graph, edge, static_cast<std::uint32_t>(e), out);
    if (!fits) return false;
  }
  return true;
}

}  // namespace lanefuse
