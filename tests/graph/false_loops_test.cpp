// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// False loop closures, and what becomes of a graph whose switches turn them off.
#include "graph/false_loops.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "graph/g2o.hpp"
#include "graph/loops.hpp"
#include "graph/place_comparison.hpp"
#include "graph/random_graph.hpp"
#include "graph/solver.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

using testing::GraphMaker;

PoseGraph drive() {
  return GraphMaker({.seed = 3, .poses = 260, .landmarks = 0, .ties = 0, .loops = 60, .noise = 0.01}).make();
}

PoseGraph spoilt(PoseGraph graph, std::size_t count, std::uint64_t seed) {
  Random random(seed, "false_loops");
  add_false_loops(graph, count, random);
  return graph;
}

SolverConfig squared() {
  SolverConfig config;
  config.max_iterations = 100;
  config.switch_form = SwitchForm::squared;
  return config;
}

TEST(FalseLoops, JoinPosesThatAreFarApart) {
  const PoseGraph graph = drive(), bad = spoilt(graph, 50, 1);
  ASSERT_EQ(bad.edges.size(), graph.edges.size() + 50);
  for (std::size_t i = graph.edges.size(); i < bad.edges.size(); ++i) {
    const Edge& edge = bad.edges[i];
    EXPECT_TRUE(is_loop(bad, edge));
    const Eigen::Vector2d apart =
        bad.vertices[edge.from].pose.position() - bad.vertices[edge.to].pose.position();
    EXPECT_GT(apart.norm(), 20);
  }
}

TEST(FalseLoops, TheSeedDecides) {
  const PoseGraph a = spoilt(drive(), 20, 1), b = spoilt(drive(), 20, 1), c = spoilt(drive(), 20, 2);
  EXPECT_EQ(a.edges.back().measurement, b.edges.back().measurement);
  EXPECT_EQ(a.edges.back().from, b.edges.back().from);
  EXPECT_NE(a.edges.back().measurement, c.edges.back().measurement);
}

TEST(FalseLoops, NeedALoopToBeLike) {
  PoseGraph chain = GraphMaker({.poses = 20, .landmarks = 0, .ties = 0, .loops = 0}).make();
  Random random(1, "false_loops");
  EXPECT_THROW(add_false_loops(chain, 1, random), Error);
}

TEST(FalseLoops, M3500SurvivesAThousand) {
  const auto file = testing::real_data("pose_graphs/M3500.g2o");
  LANEFUSE_NEEDS_DATA(file);
  G2oGraph clean = read_g2o(file), bad = clean;
  bad.graph = spoilt(std::move(bad.graph), 1000, 5);
  make_loops_switchable(bad.graph, 1);
  make_schur_solver()->solve(clean.graph, squared());
  const SolveResult result = make_schur_solver()->solve(bad.graph, squared());
  EXPECT_EQ(result.status, SolveStatus::converged);
  EXPECT_LT(compare_places(bad, clean).rmse, 0.02);
  // What light terms are left out of is only the way there.
  EXPECT_NEAR(chi_squared(bad.graph, SwitchForm::squared), result.final_chi2, 1e-9 * result.final_chi2);
}

TEST(PlaceComparison, SeesThroughAMoveOfTheWhole) {
  G2oGraph a{drive(), {}, {}}, b = a;
  for (Vertex& vertex : b.graph.vertices) vertex.pose = Pose2{5, -3, 2} * vertex.pose;
  EXPECT_LT(compare_places(a, b).farthest, 1e-9);
  b.graph.vertices.front().pose.x += 1;
  const PlaceComparison comparison = compare_places(a, b);
  EXPECT_NEAR(comparison.farthest, 1, 0.05);
  EXPECT_NEAR(comparison.rmse, 1 / std::sqrt(260.0), 0.005);
}

TEST(PlaceComparison, GoesByIds) {
  G2oGraph a{drive(), {}, {}}, b = a;
  for (std::size_t v = 0; v < a.graph.vertices.size(); ++v) a.vertex_ids.push_back(static_cast<int>(v) + 100);
  const PlaceComparison comparison = compare_places(a, b);
  EXPECT_EQ(comparison.compared, 160U);
  EXPECT_EQ(comparison.only_in_a, 100U);
  EXPECT_EQ(comparison.only_in_b, 100U);
  b.vertex_ids.assign(b.graph.vertices.size(), 0);
  EXPECT_THROW(compare_places(a, b), Error);
}

}  // namespace
}  // namespace lanefuse
