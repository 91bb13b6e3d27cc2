// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/graph_file.hpp"

#include <sstream>

#include "core/error.hpp"
#include "graph/toro.hpp"

namespace lanefuse {

GraphFormat graph_format(const std::filesystem::path& file) {
  if (file.extension() == ".g2o") return GraphFormat::g2o;
  if (file.extension() == ".graph") return GraphFormat::toro;
  throw configuration_error(file.string(), "has an ending that names no format of graphs",
                            "call it .g2o, or .graph for TORO");
}

std::string graph_text(const G2oGraph& graph, GraphFormat format) {
  std::ostringstream text;
  if (format == GraphFormat::toro) {
    write_toro(text, graph);
  } else {
    write_g2o(text, graph);
  }
  return text.str();
}

std::vector<std::string> lost_in(GraphFormat format, const G2oGraph& graph) {
  return format == GraphFormat::toro ? lost_in_toro(graph) : std::vector<std::string>{};
}

}  // namespace lanefuse
