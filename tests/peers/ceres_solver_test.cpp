// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Ceres behind our interface finds what our own solver finds, whatever its setting.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "graph/loops.hpp"
#include "graph/random_graph.hpp"
#include "peers/named_solver.hpp"
#include "peers/solver_race.hpp"

namespace lanefuse {
namespace {

using testing::GraphMaker;

PoseGraph noisy_graph(unsigned seed) {
  return GraphMaker({.seed = seed, .poses = 20, .landmarks = 15, .ties = 6, .loops = 8, .noise = 0.1}).make();
}

SolverConfig to_the_end(SwitchForm form) {
  SolverConfig config;
  config.max_iterations = 300;
  config.relative_tolerance = 1e-12;
  config.switch_form = form;
  return config;
}

TEST(CeresSolver, EverySettingFindsTheSameOptimum) {
  PoseGraph own = noisy_graph(1);
  const double optimum = make_solver("direct")->solve(own, to_the_end(SwitchForm::linear)).final_chi2;
  for (const std::string& setting : ceres_settings()) {
    SCOPED_TRACE(setting);
    PoseGraph graph = noisy_graph(1);
    const SolveResult result = make_ceres_solver(setting)->solve(graph, to_the_end(SwitchForm::linear));
    EXPECT_TRUE(result.ok());
    EXPECT_NEAR(result.final_chi2, optimum, 1e-6 * optimum);
    EXPECT_NEAR(chi_squared(graph), result.final_chi2, 1e-9 * optimum);
  }
}

TEST(CeresSolver, SwitchesAreEliminatedAsOurs) {
  for (const SwitchForm form : {SwitchForm::linear, SwitchForm::squared}) {
    PoseGraph own = noisy_graph(2), graph = own;
    for (PoseGraph* g : {&own, &graph}) make_loops_switchable(*g, 8);
    const double optimum = make_solver("direct")->solve(own, to_the_end(form)).final_chi2;
    EXPECT_NEAR(make_solver("ceres")->solve(graph, to_the_end(form)).final_chi2, optimum, 1e-6 * optimum);
    for (std::size_t k = 0; k < own.switches.size(); ++k) {
      EXPECT_NEAR(graph.switches[k].value, own.switches[k].value, 1e-3);
    }
  }
}

TEST(CeresSolver, FixedVerticesStayBitByBit) {
  PoseGraph graph = noisy_graph(3);
  const PoseGraph before = graph;
  make_solver("ceres")->solve(graph, {});
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    EXPECT_EQ(graph.vertices[v].pose == before.vertices[v].pose, graph.vertices[v].fixed) << v;
  }
}

TEST(CeresSolver, AKeptProblemFollowsTheGraph) {
  const auto kept = make_ceres_solver();
  for (const unsigned seed : {4U, 5U, 4U}) {
    PoseGraph graph = noisy_graph(seed), other = graph;
    kept->solve(graph, to_the_end(SwitchForm::linear));
    graph.vertices.front().pose.x += 0.3;  // the same problem from elsewhere
    const double again = kept->solve(graph, to_the_end(SwitchForm::linear)).final_chi2;
    EXPECT_NEAR(again, make_ceres_solver()->solve(other, to_the_end(SwitchForm::linear)).final_chi2,
                1e-6 * again);
  }
}

TEST(CeresSolver, FaultsAreNamedAndChangeNothing) {
  PoseGraph graph = noisy_graph(6);
  for (Vertex& vertex : graph.vertices) vertex.fixed = false;
  const Pose2 before = graph.vertices.front().pose;
  EXPECT_EQ(make_solver("ceres")->solve(graph, {}).status, SolveStatus::no_fixed_vertex);
  EXPECT_EQ(graph.vertices.front().pose, before);
}

TEST(CeresSolver, RefusesASharedSwitch) {
  PoseGraph graph = noisy_graph(7);
  graph.switches.push_back({});
  graph.edges[0].switch_index = graph.edges[1].switch_index = 0;
  EXPECT_THROW(make_solver("ceres")->solve(graph, {}), Error);
}

TEST(NamedSolver, UnknownNamesAreRefused) {
  for (const char* name : {"g2o", "", "direct:x", "ceres:x"}) EXPECT_THROW(make_solver(name), Error) << name;
}

TEST(SolverRace, CountsEachCycleOfBothAndNeverTheProblem) {
  double now = 0;
  const auto clock = [&now] { return now += 1; };  // each look takes a millisecond
  SolverRace race(make_solver("direct"), make_ceres_solver(), clock);
  for (int cycle = 0; cycle < 3; ++cycle) race.run(noisy_graph(8), {});
  EXPECT_EQ(race.own().ms, (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(race.peer().ms, race.own().ms);
  EXPECT_EQ(race.own().failed, 0);
  race.forget();
  EXPECT_EQ(race.own().percentile(0.5), 0);
}

TEST(SolverRace, TheFastestSettingIsChosen) {
  // A clock that jumps by 10 a look, and by 1 while the third setting has its turn.
  const std::vector<PoseGraph> starts{noisy_graph(9)};
  int looks = 0;
  double now = 0;
  const auto clock = [&] { return now += looks++ / 2 / 3 == 2 ? 1 : 10; };
  EXPECT_EQ(best_ceres_setting(starts, {}, clock), ceres_settings()[2]);
}

TEST(SubWindow, KeepsItsShareOfTheLandmarksAndWhatJoinsThem) {
  PoseGraph graph = noisy_graph(10);
  const PoseGraph part = sub_window(graph, 0.4);
  const auto landmarks = std::count_if(part.vertices.begin(), part.vertices.end(),
                                       [](const Vertex& v) { return v.role == VertexRole::landmark; });
  EXPECT_EQ(landmarks, 6);
  EXPECT_EQ(part.vertices.size(), 26U);
  PoseGraph solved = part;
  EXPECT_TRUE(make_solver("direct")->solve(solved, {}).ok());
}

}  // namespace
}  // namespace lanefuse
