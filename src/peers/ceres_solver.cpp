// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/ceres_solver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <ceres/solver.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "graph/soundness.hpp"
#include "peers/ceres_problem.hpp"
#include "peers/ceres_settings.hpp"

namespace lanefuse {

namespace {

class CeresSolver final : public GraphSolver {
 public:
  explicit CeresSolver(const CeresSetting& setting) : setting_(setting) {}

  void prepare(const PoseGraph& graph, const SolverConfig& config) override {
    if (!problem_ || !problem_->fits(graph, config.switch_form)) problem_.emplace(graph, config.switch_form);
  }
  SolveResult solve(PoseGraph& graph, const SolverConfig& config) override;
  SolveResult solve_prepared(PoseGraph& graph, const SolverConfig& config) override;

 private:
  const CeresSetting& setting_;
  std::optional<CeresProblem> problem_;
};

SolveResult CeresSolver::solve(PoseGraph& graph, const SolverConfig& config) {
  SolveResult result;
  if (const auto fault = find_fault(graph)) {
    result.status = *fault;
    return result;
  }
  prepare(graph, config);
  return solve_prepared(graph, config);
}

SolveResult CeresSolver::solve_prepared(PoseGraph& graph, const SolverConfig& config) {
  SolveResult result;
  problem_->read_places(graph);
  ceres::Solver::Options options = ceres_options(setting_, *problem_);
  options.max_num_iterations = config.max_iterations;
  options.function_tolerance = config.relative_tolerance;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem_->problem(), &summary);
  result.iterations = static_cast<int>(summary.iterations.size()) - 1;
  result.initial_chi2 = 2 * summary.initial_cost;
  result.final_chi2 = 2 * summary.final_cost;
  if (!summary.IsSolutionUsable() || !std::isfinite(result.final_chi2)) {
    result.status = std::isfinite(result.initial_chi2) ? SolveStatus::singular : SolveStatus::not_finite;
    return result;
  }
  result.status = summary.termination_type == ceres::CONVERGENCE ? SolveStatus::converged
                                                                 : SolveStatus::iterations_exhausted;
  problem_->write_places(graph);
  return result;
}

}  // namespace

bool has_ceres() { return true; }

std::vector<std::string> ceres_settings() {
  std::vector<std::string> names;
  for (const CeresSetting& setting : all_ceres_settings()) names.push_back(setting.name);
  return names;
}

std::unique_ptr<GraphSolver> make_ceres_solver(std::string_view setting) {
  const auto& all = all_ceres_settings();
  const auto found = setting.empty() ? all.begin()
                                     : std::find_if(all.begin(), all.end(),
                                                    [&](const CeresSetting& s) { return s.name == setting; });
  if (found == all.end()) {
    throw configuration_error("solver ceres", fmt::format("has no setting {}", setting),
                              fmt::format("one of {}", fmt::join(ceres_settings(), ", ")));
  }
  return std::make_unique<CeresSolver>(*found);
}

}  // namespace lanefuse
