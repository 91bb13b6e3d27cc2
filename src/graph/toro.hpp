// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "graph/g2o.hpp"

namespace lanefuse {

/// Writes TORO's text of a planar graph, which `read_g2o` reads as well:
///
///     VERTEX2 id x y heading
///     EDGE2 from to x y heading xx xy yy hh xh yh
///
/// Each number stands in its shortest form that is read back to the last bit.
void write_toro(std::ostream& out, const G2oGraph& graph);

/// What of a graph TORO has no words for, one sentence each; empty if nothing is lost.
std::vector<std::string> lost_in_toro(const G2oGraph& graph);

}  // namespace lanefuse
