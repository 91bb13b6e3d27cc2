// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/graph_files_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "graph/false_loops.hpp"
#include "graph/graph_file.hpp"
#include "graph/loops.hpp"

namespace lanefuse {

namespace {

using Json = nlohmann::ordered_json;

Json sizes(const PoseGraph& graph) {
  return {{"vertices", graph.vertices.size()},
          {"edges", graph.edges.size()},
          {"switches", graph.switches.size()}};
}

}  // namespace

Json describe(const PlaceComparison& comparison) {
  return {{"compared", comparison.compared},   {"only_in_a", comparison.only_in_a},
          {"only_in_b", comparison.only_in_b}, {"ate_m", comparison.rmse},
          {"max_m", comparison.farthest},      {"heading_rmse_rad", comparison.heading_rmse}};
}

std::string in_words(const PlaceComparison& comparison) {
  std::string text =
      fmt::format("ATE {:.6f} m, farthest {:.6f} m, heading {:.6f} rad; {} vertices compared",
                  comparison.rmse, comparison.farthest, comparison.heading_rmse, comparison.compared);
  if (comparison.only_in_a + comparison.only_in_b > 0) {
    text += fmt::format(", {} only in the first, {} only in the second", comparison.only_in_a,
                        comparison.only_in_b);
  }
  return text;
}

void tell_losses(const std::filesystem::path& output, const std::vector<std::string>& losses) {
  for (const std::string& loss : losses) fmt::print(stderr, "lost in {}: {}\n", output.string(), loss);
}

int graph_convert(const GraphConvertOptions& options) {
  check_output(options.output, options.force, options.file);
  const GraphFormat format = graph_format(options.output);
  const G2oGraph graph = read_g2o(options.file);
  const auto losses = lost_in(format, graph);
  tell_losses(options.output, losses);
  write_text(options.output, graph_text(graph, format));
  if (options.json) {
    Json json = sizes(graph.graph);
    json["lost"] = losses;
    fmt::print("{}\n", json.dump());
  } else {
    fmt::print("{} vertices, {} edges -> {}\n", graph.graph.vertices.size(), graph.graph.edges.size(),
               options.output.string());
  }
  return 0;
}

int graph_spoil(const GraphSpoilOptions& options) {
  check_output(options.output, options.force, options.file);
  const GraphFormat format = graph_format(options.output);
  if (!(options.switch_prior > 0)) {
    throw configuration_error("--switch-prior", fmt::format("{} is not above 0", options.switch_prior));
  }
  G2oGraph graph = read_g2o(options.file);
  Random random(options.seed, "false_loops");
  add_false_loops(graph.graph, options.outliers, random);
  if (options.switchable) {
    make_loops_switchable(graph.graph, options.switch_prior);
    number_new_switches(graph);
  }
  tell_losses(options.output, lost_in(format, graph));
  write_text(options.output, graph_text(graph, format));
  if (options.json) {
    Json json = sizes(graph.graph);
    json["outliers"] = options.outliers;
    fmt::print("{}\n", json.dump());
  } else {
    fmt::print("{} false loop closures among {} edges -> {}\n", options.outliers, graph.graph.edges.size(),
               options.output.string());
  }
  return 0;
}

int graph_compare(const GraphCompareOptions& options) {
  const PlaceComparison comparison = compare_places(read_g2o(options.a), read_g2o(options.b));
  if (options.json) {
    fmt::print("{}\n", describe(comparison).dump());
  } else {
    fmt::print("{}\n", in_words(comparison));
  }
  return 0;
}

}  // namespace lanefuse
