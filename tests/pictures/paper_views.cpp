// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pictures/paper_views.hpp"

#include <fmt/format.h>

#include "support/paper_scenes.hpp"

namespace lanefuse {
namespace {

using testing::LaneChangeScene;
using testing::Sighting;

std::string kind_of(const EdgeOrigin& origin) {
  switch (origin.kind) {
    case EdgeKind::odometry:
      return "odometry";
    case EdgeKind::width:
      return "width";
    case EdgeKind::smoothing:
      return "smoothing";
    case EdgeKind::measurement:
      break;
  }
  return origin.source == Source::objects ? "vehicle measured" : fmt::format("{} measured", to_string(origin.source));
}

/// The graph of two cycles as it stands in the window.
GraphView example_view() {
  const auto drive = testing::graph_slam_example();
  const SlidingWindow& window = drive->window();
  GraphView view{"One vehicle in two cycles, and a marking feature f* that two cameras saw", {}, {}};
  for (VertexId id = 0; id < window.graph().vertices.size(); ++id) {
    const Vertex& vertex = window.graph().vertices[id];
    const WindowVertex& about = window.vertex(id);
    const bool now = vertex.role == VertexRole::pose ? vertex.fixed : vertex.pose.x > 18;
    const std::string when = now ? "t" : "t-1";
    const bool tracked = about.track_id != kNoTrack;
    const std::string side = about.side == Side::left ? "left" : "right";
    if (vertex.role == VertexRole::pose) {
      view.nodes.push_back({vertex.pose.x, vertex.pose.y, "x, " + when, "our car", {}});
    } else {
      view.nodes.push_back({vertex.pose.x, vertex.pose.y, tracked ? side + ", " + when : "f*", "lane feature", {}});
    }
  }
  for (std::size_t i = 0; i < window.graph().edges.size(); ++i) {
    const Edge& edge = window.graph().edges[i];
    view.edges.push_back({edge.from, edge.to, kind_of(window.origin(i)), false});
  }
  return view;
}

constexpr const char* kVehicle = "vehicle's feature";
constexpr const char* kMarking = "marking feature of the cameras";
constexpr const char* kBoth = "both fused";

bool seen_by(const WindowVertex& vertex, Source source) { return vertex.hits[static_cast<std::size_t>(source)] > 0; }

bool is_fused(const WindowVertex& vertex) {
  return seen_by(vertex, Source::objects) && seen_by(vertex, Source::serial_camera);
}

/// (a) What was measured, and which marking feature each of the vehicle's features was taken for.
GraphView association_view() {
  const auto drive = LaneChangeScene{}.run();
  const SlidingWindow& window = drive->window();
  GraphView view{"(a) The features as measured, associated while the graph is built", {}, {}};
  for (const std::size_t i : testing::edges_of(window, EdgeKind::measurement)) {
    const Edge& edge = window.graph().edges[i];
    const Source source = window.origin(i).source;
    if (source == Source::high_resolution_camera) continue;  // stands where the serial camera's stands
    const Pose2 measured = window.graph().vertices[edge.from].pose * edge.measurement;
    view.nodes.push_back({measured.x, measured.y, "", source == Source::objects ? kVehicle : kMarking, {}});
    if (source != Source::objects || !is_fused(window.vertex(edge.to))) continue;
    // The cameras' sets of a cycle come first: their feature is among the nodes.
    for (std::size_t n = 0; n + 1 < view.nodes.size(); ++n) {
      const GraphNode& node = view.nodes[n];
      const double apart = std::hypot(node.x - measured.x, node.y - window.graph().vertices[edge.to].pose.y);
      if (node.kind == kMarking && apart < 0.5) view.edges.push_back({view.nodes.size() - 1, n, "associated", false});
    }
  }
  return view;
}

/// (b), (c), (d) The solved features; each sighting says how far its two are from each other.
GraphView solved_view(const std::string& title, const LaneChangeScene& scene) {
  const auto drive = scene.run();
  const SlidingWindow& window = drive->window();
  GraphView view{title, {}, {}};
  std::vector<std::size_t> node_of(window.graph().vertices.size());
  // Vehicles first: kinds keep their colours from picture to picture.
  for (const char* kind : {kVehicle, kMarking, kBoth}) {
    for (VertexId id = 0; id < window.graph().vertices.size(); ++id) {
      const Vertex& vertex = window.graph().vertices[id];
      const WindowVertex& about = window.vertex(id);
      const char* own = is_fused(about) ? kBoth : seen_by(about, Source::objects) ? kVehicle : kMarking;
      if (vertex.role != VertexRole::landmark || own != kind) continue;
      node_of[id] = view.nodes.size();
      view.nodes.push_back({vertex.pose.x, vertex.pose.y, "", own, {}});
    }
  }
  for (const Sighting& s : testing::sightings(window)) {
    view.nodes[node_of[s.right]].label = fmt::format("{:.2f} m", testing::width_of(window, s));
  }
  for (const EdgeKind kind : {EdgeKind::width, EdgeKind::smoothing}) {
    for (const std::size_t i : testing::edges_of(window, kind)) {
      const Edge& edge = window.graph().edges[i];
      const bool off = edge.switch_index != kNoSwitch && window.graph().switches[edge.switch_index].value < 0.5;
      view.edges.push_back({node_of[edge.from], node_of[edge.to], kind_of(window.origin(i)), off});
    }
  }
  return view;
}

}  // namespace

std::vector<NamedView> paper_views() {
  return {
      {"graph_example.svg", example_view()},
      {"lane_change_a.svg", association_view()},
      {"lane_change_b.svg", solved_view("(b) Solved without width and smoothing edges: the widths go astray", {})},
      {"lane_change_c.svg", solved_view("(c) Solved with width edges: one lane wide again", {.width_edges = true})},
      {"lane_change_d.svg", solved_view("(d) Solved with smoothing edges, too: two of them switch off",
                                        {.width_edges = true, .smoothing_edges = true})},
  };
}

}  // namespace lanefuse
