// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// Whether an edge closes a loop: it leads between poses whose places in the graph do not follow each other.
bool is_loop(const PoseGraph& graph, const Edge& edge);

/// Gives every loop closure a switch of its own with this prior, unless it has one already.
void make_loops_switchable(PoseGraph& graph, double prior);

}  // namespace lanefuse
