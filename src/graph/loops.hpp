// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// Gives every loop closure a switch of its own with this prior: every edge between poses whose places in the
/// graph do not follow each other, unless it has a switch already.
void make_loops_switchable(PoseGraph& graph, double prior);

}  // namespace lanefuse
