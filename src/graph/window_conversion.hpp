// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "graph/pose_graph.hpp"
#include "graph/window_graph.hpp"

namespace lanefuse {

/// The window as any planar pose graph: first the poses, from old to new, of which the newest is fixed, then
/// the landmarks by id; edges are the steps, the observations, the ties. Reuses what `graph` has.
void copy(const WindowGraph& window, PoseGraph& graph);

/// Moves the window's poses, landmarks and switches to where they are in a graph that `copy` made of it.
void take_places(const PoseGraph& graph, WindowGraph& window);

/// The window of a pose graph, and where its vertices went.
struct WindowOfGraph {
  WindowGraph window;
  std::vector<WindowGraph::Id> vertices;  ///< by VertexId: a pose or a landmark, as the role says
  std::vector<WindowGraph::Id> switches;  ///< the tie of each switch
};

/// False if the graph is no window: see make_lane_graph_solver(). The graph must be sound.
bool to_window(const PoseGraph& graph, WindowOfGraph& out);

}  // namespace lanefuse
