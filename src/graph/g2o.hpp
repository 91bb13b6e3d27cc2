// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// A graph with the numbers its file knows vertices and switches by. Where the numbers are missing, the
/// writer counts.
struct G2oGraph {
  PoseGraph graph;
  std::vector<std::int64_t> vertex_ids;  ///< one a vertex
  std::vector<std::int64_t> switch_ids;  ///< one a switch
};

/// Reads the common g2o text of planar graphs. Lines may come in any order and end in LF or CRLF; `#` begins
/// a comment.
///
///     VERTEX_SE2 id x y heading
///     EDGE_SE2 from to x y heading xx xy xh yy yh hh         measurement, upper triangle of the information
///     FIX id ...                                             held vertices; without such a line the lowest
///                                                            id is held
///     VERTEX_SWITCH id value                                 a switch variable
///     EDGE_SE2_SWITCHABLE from to switch x y heading xx ...  an edge it switches, as s e: the *squared*
///                                                            SwitchForm
///     EDGE_SWITCH_PRIOR switch 1 information                 its prior, which every switch must have
///
/// TORO's VERTEX2 and EDGE2 (`write_toro`) are taken as well.
///
/// Vertices that edges name but no line places are placed along the edges (`place_along_edges`). The text has
/// no word for landmarks: they are told by `tell_landmarks`.
///
/// Throws an input Error with file and line for whatever cannot be meant: an unknown tag (an edge passed over
/// would quietly move the optimum), a wrong number of values, a value that is not finite, an information
/// matrix that is not positive semi-definite, a vertex given twice, an edge from a vertex to itself, a name
/// that nothing stands behind.
G2oGraph read_g2o(const std::filesystem::path& file);
G2oGraph read_g2o(std::istream& text, const std::string& name);

/// Gives switches that were added after reading ids that neither a vertex nor a switch has. (Where they are
/// missing altogether, the writer counts on from the vertices.)
void number_new_switches(G2oGraph& graph);

/// Writes what `read_g2o` reads back to the last bit: each number in its shortest form that does so.
void write_g2o(std::ostream& out, const G2oGraph& graph);

}  // namespace lanefuse
