// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "graph/solver.hpp"

namespace lanefuse {

/// Why a graph cannot be solved, as far as that shows without solving it: edges that lead nowhere, numbers
/// that are not finite, no fixed vertex, vertices that no chain of edges joins to a fixed one.
std::optional<SolveStatus> find_fault(const PoseGraph& graph);

}  // namespace lanefuse
