// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/run_sidecar.hpp"

#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "core/error.hpp"

namespace lanefuse {

std::filesystem::path sidecar_of(const std::filesystem::path& lanes) { return lanes.string() + ".run.json"; }

void write_sidecar(const std::filesystem::path& lanes, const RunSidecar& sidecar) {
  // Relative to the sidecar, so that a folder with both can be moved.
  std::error_code failed;
  const auto folder = std::filesystem::absolute(lanes).parent_path();
  const auto relative = std::filesystem::relative(std::filesystem::absolute(sidecar.drive), folder, failed);
  nlohmann::ordered_json json{{"drive", failed ? sidecar.drive.string() : relative.string()}};
  const RunFigures& figures = sidecar.figures;
  if (figures.duration_s) json["duration_s"] = *figures.duration_s;
  if (figures.inputs) {
    json["inputs"] = {{"used", figures.inputs->used},
                      {"rejected", figures.inputs->rejected},
                      {"dropped", figures.inputs->dropped}};
  }
  if (const auto& graph = figures.largest_graph) {
    json["graph"] = {{"poses", graph->poses}, {"features", graph->features}, {"edges", graph->edges}};
  }
  auto& times = json["cycle_ms"] = nlohmann::ordered_json::array();
  for (const double ms : figures.cycle_ms) times.push_back(std::round(ms * 1000) / 1000);
  write_text(sidecar_of(lanes), json.dump() + "\n");
}

std::optional<RunSidecar> read_sidecar(const std::filesystem::path& lanes) {
  const std::filesystem::path path = sidecar_of(lanes);
  std::ifstream in(path);
  if (!in) return std::nullopt;
  try {
    const auto json = nlohmann::json::parse(in);
    RunSidecar sidecar;
    sidecar.drive = std::filesystem::absolute(lanes).parent_path() / json.at("drive").get<std::string>();
    if (json.contains("duration_s")) sidecar.figures.duration_s = json["duration_s"].get<double>();
    if (json.contains("inputs")) {
      const auto& inputs = json["inputs"];
      sidecar.figures.inputs =
          InputAccounting{inputs.at("used"), inputs.at("rejected"), inputs.at("dropped")};
    }
    if (json.contains("graph")) {
      const auto& graph = json["graph"];
      sidecar.figures.largest_graph = GraphSize{graph.at("poses"), graph.at("features"), graph.at("edges")};
    }
    if (json.contains("cycle_ms")) sidecar.figures.cycle_ms = json["cycle_ms"].get<std::vector<double>>();
    return sidecar;
  } catch (const nlohmann::json::exception& e) {
    throw input_error(path.string(), e.what(), "remove it to go on without timings");
  }
}

}  // namespace lanefuse
