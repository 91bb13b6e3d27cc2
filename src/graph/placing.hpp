// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// Gives the vertices that are not yet placed a start along the edges, each from its measurement alone: first
/// along the chain of consecutive ids (odometry, which is free of wrong loop closures), then breadth first
/// along whatever edges there are. If none is placed, the fixed vertices stay where they are. Returns a
/// vertex that no edges lead to, if there is one.
std::optional<VertexId> place_along_edges(PoseGraph& graph, const std::vector<std::int64_t>& ids,
                                          std::vector<bool> placed);

}  // namespace lanefuse
