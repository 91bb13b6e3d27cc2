// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/random.hpp"
#include "graph/pose_graph.hpp"

namespace lanefuse {

/// Adds `count` false loop closures, as a place that was recognised wrongly gives them: between poses that
/// are far apart, at a relative pose and with an information that one of the graph's own loop closures has.
///
/// A false loop is written shaken by a tenth of its length and .1 rad, so that no two are the same, and joins
/// poses that stand at least a quarter of the graph's extent from each other. Throws an input Error for a
/// graph without loop closures of its own, or with too few poses to be far apart.
void add_false_loops(PoseGraph& graph, std::size_t count, Random& random);

}  // namespace lanefuse
