// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Pose graphs through the window's solver: those that are windows by it, all others by the direct one.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "graph/g2o.hpp"
#include "graph/random_graph.hpp"
#include "graph/random_window.hpp"
#include "graph/window_conversion.hpp"
#include "graph/window_solver.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

using testing::any_shape;
using testing::GraphMaker;
using testing::WindowMaker;

SolverConfig to_the_end(SwitchForm form = SwitchForm::linear) {
  SolverConfig config;
  config.max_iterations = 300;
  config.relative_tolerance = 1e-12;
  config.switch_form = form;
  return config;
}

PoseGraph copied(const WindowGraph& window) {
  PoseGraph graph;
  copy(window, graph);
  return graph;
}

TEST(LaneGraphSolver, SolvesWhatIsAWindowAsAWindow) {
  const auto solver = make_lane_graph_solver();
  for (unsigned seed = 0; seed < 50; ++seed) {
    WindowGraph window = WindowMaker(any_shape(seed)).make();
    PoseGraph graph = copied(window);
    const PoseGraph start = graph;
    const SolveResult result = solver->solve(graph, to_the_end());
    EXPECT_EQ(result.status, SolveStatus::converged) << seed;
    EXPECT_EQ(result.fallback, SolveFallback::none) << seed;
    EXPECT_NEAR(chi_squared(graph), result.final_chi2, 1e-9 * result.final_chi2 + 1e-12) << seed;
    PoseGraph better = graph;
    const SolveResult direct = make_schur_solver()->solve(better, to_the_end());
    EXPECT_LE(result.final_chi2 - direct.final_chi2, 1e-9 * result.final_chi2 + 1e-12) << seed;
    for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
      EXPECT_NEAR(graph.vertices[v].pose.x, better.vertices[v].pose.x, 1e-6) << seed;
      if (graph.vertices[v].fixed) {
        EXPECT_EQ(graph.vertices[v].pose, start.vertices[v].pose);
      }
    }
  }
}

TEST(LaneGraphSolver, FindsTheWindowInWhateverOrderItsPartsStand) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    PoseGraph graph = copied(WindowMaker(any_shape(seed)).make());
    PoseGraph shuffled;
    std::vector<VertexId> moved(graph.vertices.size());
    for (std::size_t v = graph.vertices.size(); v-- > 0;) {
      moved[v] = static_cast<VertexId>(shuffled.vertices.size());
      shuffled.vertices.push_back(graph.vertices[v]);
    }
    shuffled.switches = graph.switches;
    for (auto edge = graph.edges.rbegin(); edge != graph.edges.rend(); ++edge) {
      shuffled.edges.push_back(*edge);
      shuffled.edges.back().from = moved[edge->from];
      shuffled.edges.back().to = moved[edge->to];
    }
    const SolveResult straight = make_lane_graph_solver()->solve(graph, to_the_end());
    const SolveResult result = make_lane_graph_solver()->solve(shuffled, to_the_end());
    EXPECT_EQ(result.fallback, SolveFallback::none) << seed;
    EXPECT_NEAR(result.final_chi2, straight.final_chi2, 1e-9 * straight.final_chi2 + 1e-12) << seed;
  }
}

/// Expects the direct solver's very answer.
void expect_not_a_window(PoseGraph graph, const std::string& why) {
  PoseGraph direct = graph;
  const SolveResult expected = make_schur_solver()->solve(direct, to_the_end());
  const SolveResult result = make_lane_graph_solver()->solve(graph, to_the_end());
  EXPECT_EQ(result.fallback, SolveFallback::not_a_window) << why;
  EXPECT_EQ(result.status, SolveStatus::converged) << why;
  EXPECT_EQ(result.final_chi2, expected.final_chi2) << why;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    EXPECT_EQ(graph.vertices[v].pose, direct.vertices[v].pose) << why;
}

TEST(LaneGraphSolver, LeavesToTheDirectSolverWhatIsNoWindow) {
  expect_not_a_window(GraphMaker({.seed = 4, .noise = 0.05}).make(), "loops between poses");
  const PoseGraph window = copied(WindowMaker({.seed = 5}).make());
  PoseGraph graph = window;
  graph.vertices[0].fixed = true;
  expect_not_a_window(graph, "two fixed poses");
  graph = window;
  std::swap(graph.vertices[0].fixed, graph.vertices[11].fixed);
  expect_not_a_window(graph, "the oldest pose is held, not the newest");
  graph = window;
  graph.edges.back().information(0, 2) = graph.edges.back().information(2, 0) = 1e-3;
  graph.edges.back().from = 3;
  expect_not_a_window(graph, "an observation whose heading depends on the position");
  graph = window;
  graph.edges.push_back(graph.edges[2]);
  expect_not_a_window(graph, "two steps between two poses");
  graph = window;
  const auto observation = static_cast<std::size_t>(
      std::find_if(graph.edges.begin(), graph.edges.end(), [](const Edge& e) { return e.to >= 12; }) -
      graph.edges.begin());
  graph.switches.push_back({2, 1});
  graph.edges[observation].switch_index = static_cast<std::uint32_t>(graph.switches.size() - 1);
  expect_not_a_window(graph, "a switched observation");
  graph = window;
  Edge& backwards = graph.edges[observation];
  std::swap(backwards.from, backwards.to);
  backwards.measurement = backwards.measurement.inverse();
  expect_not_a_window(graph, "an observation the other way round");
  graph = window;
  graph.vertices.push_back({{3, 4, 0.5}, VertexRole::landmark, true});
  Edge to_fixed = graph.edges[observation];
  to_fixed.to = static_cast<VertexId>(graph.vertices.size() - 1);
  graph.edges.push_back(to_fixed);
  expect_not_a_window(graph, "a landmark that is held");
}

TEST(LaneGraphSolver, LeavesLandmarksWithoutAnyPoseToTheDirectSolver) {
  PoseGraph graph;
  graph.vertices = {{{0, 0, 0}, VertexRole::landmark, true}, {{4, 1, 0}, VertexRole::landmark, false}};
  graph.edges.push_back({0, 1, {3, 0, 0.1}});
  expect_not_a_window(graph, "landmarks alone");
}

TEST(LaneGraphSolver, LeavesSharedSwitchesToTheDirectSolver) {
  PoseGraph graph = copied(WindowMaker({.seed = 5, .switched = 1}).make());
  ASSERT_GT(graph.switches.size(), 2U);
  for (Edge& edge : graph.edges) {
    if (edge.switch_index == 1) edge.switch_index = 0;
  }
  expect_not_a_window(graph, "two ties that share a switch");
}

TEST(LaneGraphSolver, NamesFailuresAsTheDirectSolverDoes) {
  const PoseGraph window = copied(WindowMaker({.seed = 5}).make());
  const auto status_of = [](PoseGraph graph) { return make_lane_graph_solver()->solve(graph, {}).status; };
  EXPECT_EQ(status_of({}), SolveStatus::no_fixed_vertex);
  PoseGraph graph = window;
  graph.vertices[2].pose.y = std::nan("");
  EXPECT_EQ(status_of(graph), SolveStatus::not_finite);
  graph = window;
  graph.edges[3].to = static_cast<VertexId>(graph.vertices.size());
  EXPECT_EQ(status_of(graph), SolveStatus::bad_edge);
  graph = window;
  graph.vertices.push_back({{}, VertexRole::landmark, false});
  EXPECT_EQ(status_of(graph), SolveStatus::singular);
}

class RealLaneGraph : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto file = testing::real_data(std::string("lane_graphs/") + GetParam() + ".g2o");
    LANEFUSE_NEEDS_DATA(file);
    graph_ = read_g2o(file).graph;
  }
  PoseGraph graph_;
};

TEST_P(RealLaneGraph, IsAWindowAndReachesTheOptimumOfTheDirectSolver) {
  for (const SwitchForm form : {SwitchForm::linear, SwitchForm::squared}) {
    PoseGraph direct = graph_;
    PoseGraph graph = graph_;
    const double optimum = make_schur_solver()->solve(direct, to_the_end(form)).final_chi2;
    const SolveResult result = make_lane_graph_solver()->solve(graph, to_the_end(form));
    EXPECT_EQ(result.status, SolveStatus::converged);
    EXPECT_EQ(result.fallback, SolveFallback::none);
    EXPECT_NEAR(result.final_chi2, optimum, 1e-9 * optimum);
    EXPECT_NEAR(chi_squared(graph, form), result.final_chi2, 1e-9 * optimum);
  }
}

TEST_P(RealLaneGraph, ComesWithinAThousandthInTwoIterationsFromTheFileAndWarmWithinAHundredThousandth) {
  PoseGraph best = graph_;
  const double optimum = make_lane_graph_solver()->solve(best, to_the_end()).final_chi2;
  const auto solver = make_lane_graph_solver();
  const SolveResult cold = solver->solve(graph_, {});
  EXPECT_LE(cold.final_chi2, (1 + 1e-3) * optimum);
  const SolveResult warm = solver->solve(graph_, {});
  EXPECT_LE(warm.final_chi2, (1 + 1e-5) * optimum);
  EXPECT_LE(warm.iterations, 2);
  EXPECT_EQ(warm.fallback, SolveFallback::none);
}

INSTANTIATE_TEST_SUITE_P(Windows, RealLaneGraph,
                         ::testing::Values("light", "typical", "heavy", "typical_switch"));

TEST(LaneGraphSolver, ReachesTheKnownOptimumOfTheSwitchedWindow) {
  const auto file = testing::real_data("lane_graphs/typical_switch.g2o");
  LANEFUSE_NEEDS_DATA(file);
  PoseGraph graph = read_g2o(file).graph;
  const SolveResult result = make_lane_graph_solver()->solve(graph, to_the_end(SwitchForm::squared));
  EXPECT_NEAR(result.final_chi2, 20973.5655, 1e-6 * 20973.5655);
}

}  // namespace
}  // namespace lanefuse
