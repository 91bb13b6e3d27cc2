// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// Tells landmarks from poses by what measures what, for graphs whose file does not say.
///
/// An edge leads from the one that measures. Poses measure their successors up to the newest, where a
/// window's gauge is held; landmarks measure at most each other. So whoever has no directed chain of edges to
/// a fixed vertex is taken for a landmark. If one of those is not measured by any pose, the reading is wrong
/// (a trajectory held at its beginning reads so), and every vertex is a pose.
///
/// As the role is a hint for the order of elimination, a wrong guess costs time and never the result.
void tell_landmarks(PoseGraph& graph);

}  // namespace lanefuse
