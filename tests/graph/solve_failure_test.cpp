// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "graph/random_graph.hpp"
#include "graph/solver.hpp"

namespace lanefuse {
namespace {

using testing::GraphMaker;

std::vector<std::uint64_t> bits(const PoseGraph& graph) {
  std::vector<std::uint64_t> result;
  for (const Vertex& v : graph.vertices) {
    for (const double number : {v.pose.x, v.pose.y, v.pose.heading}) {
      result.push_back(std::bit_cast<std::uint64_t>(number));
    }
  }
  for (const Switch& s : graph.switches) result.push_back(std::bit_cast<std::uint64_t>(s.value));
  return result;
}

/// The status of a solution, having seen that failure left every bit where it was.
SolveStatus status_of(PoseGraph graph) {
  const auto before = bits(graph);
  SolverConfig config;
  config.max_iterations = 20;
  const SolveResult result = make_schur_solver()->solve(graph, config);
  if (!result.ok()) {
    EXPECT_EQ(bits(graph), before);
  }
  return result.status;
}

PoseGraph sound_graph() {
  PoseGraph graph = GraphMaker({.seed = 2, .noise = 0.1}).make();
  graph.switches.push_back({1, 0.5});
  graph.edges.back().switch_index = 0;
  return graph;
}

TEST(SolveFailure, TheGraphTheOthersSpoilIsSound) {
  EXPECT_LE(status_of(sound_graph()), SolveStatus::iterations_exhausted);
}

TEST(SolveFailure, NoFixedVertex) {
  PoseGraph graph = sound_graph();
  for (Vertex& v : graph.vertices) v.fixed = false;
  EXPECT_EQ(status_of(graph), SolveStatus::no_fixed_vertex);
  EXPECT_EQ(status_of(PoseGraph{}), SolveStatus::no_fixed_vertex);
}

TEST(SolveFailure, EdgesThatLeadNowhere) {
  PoseGraph graph = sound_graph();
  graph.edges[3].to = static_cast<VertexId>(graph.vertices.size());
  EXPECT_EQ(status_of(graph), SolveStatus::bad_edge);
  graph = sound_graph();
  graph.edges[3].to = graph.edges[3].from;
  EXPECT_EQ(status_of(graph), SolveStatus::bad_edge);
  graph = sound_graph();
  graph.edges[3].switch_index = 1;
  EXPECT_EQ(status_of(graph), SolveStatus::bad_edge);
}

TEST(SolveFailure, ASwitchWithoutAPriorForIt) {
  PoseGraph graph = sound_graph();
  graph.switches[0].prior = 0;
  EXPECT_EQ(status_of(graph), SolveStatus::bad_edge);
}

TEST(SolveFailure, NumbersThatAreNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    PoseGraph graph = sound_graph();
    graph.vertices[2].pose.y = bad;
    EXPECT_EQ(status_of(graph), SolveStatus::not_finite);
    graph = sound_graph();
    graph.edges[4].measurement.heading = bad;
    EXPECT_EQ(status_of(graph), SolveStatus::not_finite);
    graph = sound_graph();
    graph.edges[4].information(1, 1) = bad;
    EXPECT_EQ(status_of(graph), SolveStatus::not_finite);
  }
}

TEST(SolveFailure, NumbersThatOverflowOnTheWay) {
  PoseGraph graph = sound_graph();
  graph.vertices[2].pose.x = 1e200;
  EXPECT_EQ(status_of(graph), SolveStatus::not_finite);
}

TEST(SolveFailure, VerticesThatNothingHolds) {
  for (const VertexRole role : {VertexRole::pose, VertexRole::landmark}) {
    PoseGraph graph = sound_graph();
    graph.vertices.push_back({{1, 2, 0.3}, role, false});
    EXPECT_EQ(status_of(graph), SolveStatus::singular);
    // A second one tied to the first: each is determined by the other, both by nothing.
    graph.vertices.push_back({{4, 2, 0.1}, role, false});
    const auto last = static_cast<VertexId>(graph.vertices.size() - 1);
    graph.edges.push_back({last - 1, last, {3, 0, 0}, Eigen::Matrix3d::Identity(), kNoSwitch});
    EXPECT_EQ(status_of(graph), SolveStatus::singular);
  }
}

/// A vertex at the end of an edge that tells nothing about one direction, somewhere in a graph of this size.
PoseGraph half_determined(unsigned seed, std::size_t poses, VertexRole role) {
  GraphMaker maker({.seed = seed, .poses = poses, .noise = 0.05});
  PoseGraph graph = maker.make();
  const auto anchor = static_cast<VertexId>(poses / 2);
  const auto added = static_cast<VertexId>(graph.vertices.size());
  graph.vertices.push_back({{maker.uniform(-9, 9), maker.uniform(-9, 9), maker.uniform(-3, 3)}, role, false});
  Eigen::Matrix3d information = Eigen::Vector3d(0, 100, 2500).asDiagonal();
  graph.edges.push_back({anchor, added, {5, 0, maker.uniform(-3, 3)}, information, kNoSwitch});
  return graph;
}

RC_GTEST_PROP(SolveFailure, AVertexMeasuredInTwoDirectionsOnlyIsSingular, (unsigned seed)) {
  RC_ASSERT(status_of(half_determined(seed, 8, VertexRole::landmark)) == SolveStatus::singular);
  RC_ASSERT(status_of(half_determined(seed, 8, VertexRole::pose)) == SolveStatus::singular);
}

TEST(SolveFailure, AVertexMeasuredInTwoDirectionsOnlyIsSingularAmongManyPosesToo) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    EXPECT_EQ(status_of(half_determined(seed, 260, VertexRole::pose)), SolveStatus::singular);
    EXPECT_EQ(status_of(half_determined(seed, 260, VertexRole::landmark)), SolveStatus::singular);
  }
}

RC_GTEST_PROP(SolveFailure, ASecondDirectionMakesItWhole, (unsigned seed)) {
  PoseGraph graph = half_determined(seed, 8, VertexRole::landmark);
  graph.edges.push_back(graph.edges.back());
  // The same thing told along an axis a third of a right angle away.
  graph.edges.back().measurement.heading += 0.5;
  RC_ASSERT(status_of(graph) <= SolveStatus::iterations_exhausted);
}

TEST(SolveFailure, AnEdgeWithoutInformationDeterminesNothing) {
  PoseGraph graph = half_determined(1, 8, VertexRole::landmark);
  graph.edges.back().information.setZero();
  EXPECT_EQ(status_of(graph), SolveStatus::singular);
}

TEST(SolveFailure, ASwitchedOffEdgeDeterminesNothing) {
  PoseGraph graph = half_determined(1, 8, VertexRole::landmark);
  graph.edges.back().information = Eigen::Vector3d(100, 100, 100).asDiagonal();
  graph.edges.back().switch_index = 0;
  graph.switches.push_back({1, 1});
  EXPECT_EQ(status_of(graph), SolveStatus::singular);
}

TEST(SolveFailure, ALongChainHeldAtOneEndIsNoFailure) {
  for (const std::size_t poses : {150u, 4000u}) {
    PoseGraph graph =
        GraphMaker({.seed = 1, .poses = poses, .landmarks = 0, .loops = 0, .start_error = 0}).make();
    EXPECT_LE(status_of(graph), SolveStatus::iterations_exhausted) << poses;
  }
}

}  // namespace
}  // namespace lanefuse
