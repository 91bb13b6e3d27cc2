// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "drawing/svg.hpp"

namespace lanefuse {

/// A vertex of a graph in the plane. Kinds are words for the legend; each kind gets its own shape and colour,
/// in the order in which kinds first appear.
struct GraphNode {
  double x = 0;  ///< [m]
  double y = 0;  ///< [m]
  std::string label;
  std::string kind;
  std::optional<double> heading;  ///< [rad] drawn as a short tick
  bool label_above = false;       ///< instead of below, where an edge would cross it
};

struct GraphEdge {
  std::size_t from = 0;  ///< index of a node
  std::size_t to = 0;
  std::string kind;
  bool off = false;  ///< switched off: dashed red, whatever its kind
};

struct GraphView {
  std::string title;
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
};

/// A graph of poses and features, for explaining: the axes are stretched to hold all nodes.
Figure draw_graph(const GraphView& view);

}  // namespace lanefuse
