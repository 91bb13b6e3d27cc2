// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fusion/sliding_window.hpp"
#include "graph/window_conversion.hpp"

/// A window of the fusion laid open: its vertices and edges in lists, each with what it is.
namespace lanefuse::testing {

enum class EdgeKind { odometry, measurement, width, smoothing };

struct EdgeOrigin {
  EdgeKind kind = EdgeKind::odometry;
  Source source = Source::objects;  ///< of a measurement; ties come from objects alone
  std::uint32_t sensor_id = 0;      ///< of a measurement
};

/// The window as it stood when the view was made.
class WindowView {
 public:
  explicit WindowView(const SlidingWindow& window) : window_(window) {
    copy(window.graph(), graph_);
    const WindowGraph& graph = window.graph();
    ids_.assign(graph.chain().begin(), graph.chain().end());
    origins_.resize(graph.chain().empty() ? 0 : graph.chain().size() - 1);
    for (Id id = 0; id < graph.landmark_slots(); ++id) {
      if (!graph.is_alive(id)) continue;
      ids_.push_back(id);
      add_measurements(id);
    }
    for (Id id = 0; id < graph.tie_slots(); ++id) {
      if (!graph.is_tie(id)) continue;
      const bool width = graph.tie(id).kind == static_cast<std::uint32_t>(TieKind::width);
      origins_.push_back({width ? EdgeKind::width : EdgeKind::smoothing});
    }
  }

  /// Poses from old to new, then the features by id; edges with all of a kind in a row.
  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  [[nodiscard]] const Vertex& vertex(VertexId vertex) const { return graph_.vertices[vertex]; }
  [[nodiscard]] const Edge& edge(std::size_t edge) const { return graph_.edges[edge]; }
  [[nodiscard]] const EdgeOrigin& origin(std::size_t edge) const { return origins_[edge]; }

  /// What the window knows of a landmark of graph(), or of a pose.
  [[nodiscard]] const WindowFeature& feature(VertexId vertex) const { return window_.feature(ids_[vertex]); }
  [[nodiscard]] const Keyframe& keyframe(VertexId vertex) const { return window_.keyframe(ids_[vertex]); }
  [[nodiscard]] SlidingWindow::Id id(VertexId vertex) const { return ids_[vertex]; }

  /// The numbers of the edges of one kind, in order.
  [[nodiscard]] std::vector<std::size_t> edges_of(EdgeKind kind) const {
    std::vector<std::size_t> edges;
    for (std::size_t i = 0; i < origins_.size(); ++i) {
      if (origins_[i].kind == kind) edges.push_back(i);
    }
    return edges;
  }

  /// The error of an edge as the window stands.
  [[nodiscard]] Eigen::Vector3d error_of(std::size_t edge) const {
    const Edge& e = graph_.edges[edge];
    return error(e, graph_.vertices[e.from].pose, graph_.vertices[e.to].pose);
  }

  /// What an edge's switch says: 1 for one that has none.
  [[nodiscard]] double switch_of(std::size_t edge) const {
    const std::uint32_t index = graph_.edges[edge].switch_index;
    return index == kNoSwitch ? 1 : graph_.switches[index].value;
  }

 private:
  using Id = SlidingWindow::Id;

  void add_measurements(Id landmark) {
    const WindowGraph& graph = window_.graph();
    for (Id id = graph.first_block(landmark); id != WindowGraph::kNone; id = graph.block(id).next) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (graph.block(id).pose[k] == WindowGraph::kNowhere) continue;
        const std::uint64_t witness = graph.block(id).witness[k];
        origins_.push_back({EdgeKind::measurement, static_cast<Source>(witness >> 32U),
                            static_cast<std::uint32_t>(witness)});
      }
    }
  }

  const SlidingWindow& window_;
  PoseGraph graph_;
  std::vector<EdgeOrigin> origins_;  ///< beside the edges
  std::vector<Id> ids_;              ///< beside the vertices
};

/// The numbers of the window's edges of one kind.
inline std::vector<std::size_t> edges_of(const SlidingWindow& window, EdgeKind kind) {
  return WindowView(window).edges_of(kind);
}

}  // namespace lanefuse::testing
