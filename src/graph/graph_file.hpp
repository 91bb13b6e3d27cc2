// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graph/g2o.hpp"

namespace lanefuse {

/// The format of a graph that a file name's ending asks for.
enum class GraphFormat : std::uint8_t { g2o = 0, toro = 1 };

/// `.g2o`, or `.graph` for TORO; throws a configuration Error for any other ending.
GraphFormat graph_format(const std::filesystem::path& file);

/// The graph as text of a format.
std::string graph_text(const G2oGraph& graph, GraphFormat format);

/// What of a graph this format has no words for, one sentence each; empty if nothing is lost.
std::vector<std::string> lost_in(GraphFormat format, const G2oGraph& graph);

}  // namespace lanefuse
