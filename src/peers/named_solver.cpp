// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/named_solver.hpp"

#include <array>

#include <fmt/format.h>

#include "core/error.hpp"
#include "graph/window_solver.hpp"
#include "peers/ceres_solver.hpp"

namespace lanefuse {

namespace {

struct NamedSolver {
  std::string_view name;
  std::unique_ptr<GraphSolver> (*make)(std::string_view setting);
};

const std::array kSolvers{
    NamedSolver{"lanefuse", [](std::string_view) { return make_lane_graph_solver(); }},
    NamedSolver{"direct", [](std::string_view) { return make_schur_solver(); }},
    NamedSolver{
        "ceres",
        [](std::string_view setting) -> std::unique_ptr<GraphSolver> { return make_ceres_solver(setting); }},
};

}  // namespace

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const NamedSolver& solver : kSolvers) names.emplace_back(solver.name);
  return names;
}

std::unique_ptr<GraphSolver> make_solver(std::string_view name) {
  const std::size_t colon = name.find(':');
  const std::string_view kind = name.substr(0, colon);
  const std::string_view setting = colon == std::string_view::npos ? "" : name.substr(colon + 1);
  for (const NamedSolver& solver : kSolvers) {
    if (solver.name == kind && (setting.empty() || kind == "ceres")) return solver.make(setting);
  }
  throw configuration_error("--solver", fmt::format("{} is none", name),
                            fmt::format("one of {}", fmt::join(solver_names(), ", ")));
}

}  // namespace lanefuse
