// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pictures/paper_views.hpp"

#include <map>

#include <fmt/format.h>

#include "support/paper_scenes.hpp"

namespace lanefuse {
namespace {

using testing::EdgeKind;
using testing::EdgeOrigin;
using testing::LaneChangeScene;
using testing::Sighting;
using testing::WindowView;

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
  switch (origin.source) {
    case Source::serial_camera:
      return "seen by the serial camera";
    case Source::high_resolution_camera:
      return "seen by the high-resolution camera";
    default:
      return "vehicle measured";
  }
}

/// The edges in the order of the legend, which also gives them their colours.
void add_edges(const WindowView& window, GraphView& view) {
  for (const EdgeKind kind :
       {EdgeKind::odometry, EdgeKind::width, EdgeKind::smoothing, EdgeKind::measurement}) {
    for (const Source source : {Source::serial_camera, Source::objects, Source::high_resolution_camera}) {
      for (const std::size_t i : window.edges_of(kind)) {
        if (window.origin(i).source != source) continue;
        const Edge& edge = window.edge(i);
        view.edges.push_back({edge.from, edge.to, kind_of(window.origin(i)), false});
      }
    }
  }
}

/// The graph of two cycles as it stands in the window.
GraphView example_view() {
  const auto drive = testing::graph_slam_example();
  const WindowView window = drive->view();
  GraphView view{"One vehicle in two cycles, and a marking feature f* that two cameras saw", {}, {}};
  for (VertexId id = 0; id < window.graph().vertices.size(); ++id) {
    const Vertex& vertex = window.vertex(id);
    const bool now = vertex.role == VertexRole::pose ? vertex.fixed : vertex.pose.x > 20;
    const std::string when = now ? "t" : "t-1";
    if (vertex.role == VertexRole::pose) {
      view.nodes.push_back({vertex.pose.x, vertex.pose.y, "x, " + when, "our car"});
    } else {
      const bool tracked = window.feature(id).track_id != kNoTrack;
      const bool left = window.feature(id).side == Side::left;
      const std::string name = tracked ? (left ? "left, " : "right, ") + when : "f*";
      view.nodes.push_back({vertex.pose.x, vertex.pose.y, name, "lane feature", {}, left});
    }
  }
  add_edges(window, view);
  return view;
}

constexpr const char* kVehicle = "vehicle's feature";
constexpr const char* kMarking = "marking feature of the cameras";
constexpr const char* kBoth = "both fused";

bool seen_by(const WindowFeature& feature, Source source) {
  return feature.hits[static_cast<std::size_t>(source)] > 0;
}

bool is_fused(const WindowFeature& feature) {
  return seen_by(feature, Source::objects) && seen_by(feature, Source::serial_camera);
}

bool is_in_left_lane(const WindowView& window, const Sighting& s) {
  return !is_fused(window.feature(s.left));
}

/// (a) What was measured, and which marking feature each of the vehicle's features was taken for.
GraphView association_view() {
  const auto drive = LaneChangeScene{}.run();
  const WindowView window = drive->view();
  GraphView view{"(a) The features as measured, associated while the graph is built", {}, {}};
  std::map<VertexId, std::size_t> vehicle_node;
  // The high-resolution camera's features stand where the serial camera's do, to a few centimetres.
  for (const Source source : {Source::objects, Source::serial_camera}) {
    for (const std::size_t i : window.edges_of(EdgeKind::measurement)) {
      if (window.origin(i).source != source) continue;
      const Edge& edge = window.edge(i);
      const Pose2 measured = window.vertex(edge.from).pose * edge.measurement;
      const std::size_t node = view.nodes.size();
      view.nodes.push_back({measured.x, measured.y, "", source == Source::objects ? kVehicle : kMarking});
      if (source == Source::objects) {
        vehicle_node[edge.to] = node;
      } else if (const auto same = vehicle_node.find(edge.to); same != vehicle_node.end()) {
        view.edges.push_back({same->second, node, "associated", false});
      }
    }
  }
  return view;
}

/// (b), (c), (d) The solved features; each sighting says how far its two are from each other.
GraphView solved_view(const std::string& title, const LaneChangeScene& scene) {
  const auto drive = scene.run();
  const WindowView window = drive->view();
  GraphView view{title, {}, {}};
  std::vector<std::size_t> node_of(window.graph().vertices.size());
  // Vehicles first: kinds keep their colours from picture to picture.
  for (const char* kind : {kVehicle, kMarking, kBoth}) {
    for (VertexId id = 0; id < window.graph().vertices.size(); ++id) {
      const Vertex& vertex = window.vertex(id);
      if (vertex.role != VertexRole::landmark) continue;
      const WindowFeature& about = window.feature(id);
      const char* own = is_fused(about) ? kBoth : seen_by(about, Source::objects) ? kVehicle : kMarking;
      if (own != kind) continue;
      node_of[id] = view.nodes.size();
      view.nodes.push_back({vertex.pose.x, vertex.pose.y, "", own});
    }
  }
  for (const Sighting& s : testing::sightings(window)) {
    // Where no edge runs: above the pairs before the lane change, below those after it.
    const bool before = is_in_left_lane(window, s);
    GraphNode& node = view.nodes[node_of[before ? s.left : s.right]];
    node.label = fmt::format("{:.2f} m", testing::width_of(window, s));
    node.label_above = before;
  }
  for (const EdgeKind kind : {EdgeKind::width, EdgeKind::smoothing}) {
    for (const std::size_t i : window.edges_of(kind)) {
      const Edge& edge = window.edge(i);
      const bool off = window.switch_of(i) < 0.5;
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
      {"lane_change_b.svg",
       solved_view("(b) Solved without width and smoothing edges: the widths go astray", {})},
      {"lane_change_c.svg",
       solved_view("(c) Solved with width edges: one lane wide again", {.width_edges = true})},
      {"lane_change_d.svg", solved_view("(d) Solved with smoothing edges, too: two of them switch off",
                                        {.width_edges = true, .smoothing_edges = true})},
  };
}

}  // namespace lanefuse
