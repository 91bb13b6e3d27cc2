// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/switchable.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "graph/loops.hpp"
#include "graph/random_graph.hpp"
#include "graph/solver.hpp"

namespace lanefuse {
namespace {

using testing::GraphMaker;

constexpr SwitchForm kForms[] = {SwitchForm::linear, SwitchForm::squared};

double cost_at(SwitchForm form, double s, double cost, double prior) {
  return switch_factor(form, s) * cost + prior * (1 - s) * (1 - s);
}

RC_GTEST_PROP(Switchable, ClosedFormEqualsTheBestOfAllSwitches, (unsigned seed)) {
  GraphMaker maker({.seed = seed});
  const double cost = std::exp(maker.uniform(-6, 6));
  const double prior = std::exp(maker.uniform(-3, 3));
  for (const SwitchForm form : kForms) {
    constexpr int kSteps = 20000;
    double best = prior + cost;
    int at = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const double tried = cost_at(form, static_cast<double>(i) / kSteps, cost, prior);
      if (tried < best) best = tried, at = i;
    }
    RC_ASSERT(std::abs(best_switch(form, cost, prior) - static_cast<double>(at) / kSteps) < 1.5 / kSteps);
    RC_ASSERT(switched_cost(form, cost, prior) <= best * (1 + 1e-12));
  }
}

RC_GTEST_PROP(Switchable, TheFactorIsTheSlopeOfTheEliminatedCost, (unsigned seed)) {
  GraphMaker maker({.seed = seed});
  const double cost = maker.uniform(0.01, 5);
  const double prior = maker.uniform(0.3, 3);
  RC_PRE(std::abs(cost - 2 * prior) > 1e-3);  // where the linear form's switch reaches 0
  for (const SwitchForm form : kForms) {
    constexpr double kStep = 1e-6;
    const double slope =
        (switched_cost(form, cost + kStep, prior) - switched_cost(form, cost - kStep, prior)) / (2 * kStep);
    RC_ASSERT(std::abs(slope - switch_factor(form, best_switch(form, cost, prior))) < 1e-6);
  }
}

/// A drive around a square and a half, with the loops closed where it meets itself again; the last one is
/// false.
struct Square {
  PoseGraph graph;
  std::vector<Pose2> truth;
};

Square square_drive() {
  Square result;
  GraphMaker maker({.seed = 11});
  Eigen::Matrix3d information = Eigen::Vector3d(100, 100, 1000).asDiagonal();
  const auto add_edge = [&](VertexId from, VertexId to, const Pose2& measurement) {
    const Pose2 noise{maker.uniform(-0.02, 0.02), maker.uniform(-0.02, 0.02), maker.uniform(-0.005, 0.005)};
    result.graph.edges.push_back({from, to, measurement * noise, information, kNoSwitch});
  };
  Pose2 pose;
  for (VertexId v = 0; v < 60; ++v) {
    result.truth.push_back(pose);
    result.graph.vertices.push_back({v == 0 ? pose : Pose2{}, VertexRole::pose, v == 0});
    pose = pose * Pose2{1, 0, v % 10 == 9 ? 1.5707963267948966 : 0};
  }
  for (VertexId v = 0; v + 1 < 60; ++v) {
    add_edge(v, v + 1, result.truth[v].inverse() * result.truth[v + 1]);
    result.graph.vertices[v + 1].pose = result.graph.vertices[v].pose * result.graph.edges.back().measurement;
  }
  for (VertexId v = 0; v < 20; v += 4) add_edge(v, v + 40, result.truth[v].inverse() * result.truth[v + 40]);
  add_edge(5, 25, {0, 0, 0});
  return result;
}

TEST(Switchable, AFalseLoopClosureIsSwitchedOffAndTheTrueOnesStay) {
  for (const SwitchForm form : kForms) {
    auto [graph, truth] = square_drive();
    make_loops_switchable(graph, 4);
    ASSERT_EQ(graph.switches.size(), 6u);
    SolverConfig config;
    config.max_iterations = 100;
    config.switch_form = form;
    const SolveResult result = make_schur_solver()->solve(graph, config);
    EXPECT_EQ(result.status, SolveStatus::converged);
    for (std::size_t k = 0; k + 1 < graph.switches.size(); ++k) EXPECT_GT(graph.switches[k].value, 0.8) << k;
    EXPECT_LT(graph.switches.back().value, 0.01);
    for (std::size_t v = 0; v < truth.size(); ++v) {
      EXPECT_LT((graph.vertices[v].pose.position() - truth[v].position()).norm(), 0.3);
    }
  }
}

TEST(Switchable, WithoutSwitchesTheSameFalseClosureBendsTheDrive) {
  auto [graph, truth] = square_drive();
  SolverConfig config;
  config.max_iterations = 100;
  make_schur_solver()->solve(graph, config);
  EXPECT_GT((graph.vertices[25].pose.position() - truth[25].position()).norm(), 1.0);
}

TEST(Switchable, TheSolverLeavesEachSwitchAtItsBest) {
  PoseGraph graph = GraphMaker({.seed = 12, .noise = 0.4}).make();
  make_loops_switchable(graph, 2);
  ASSERT_FALSE(graph.switches.empty());
  for (const SwitchForm form : kForms) {
    SolverConfig config;
    config.switch_form = form;
    const SolveResult result = make_schur_solver()->solve(graph, config);
    EXPECT_NEAR(result.final_chi2, chi_squared(graph, form), 1e-9 * result.final_chi2);
    for (const Edge& edge : graph.edges) {
      if (edge.switch_index == kNoSwitch) continue;
      const Eigen::Vector3d e = error(edge, graph.vertices[edge.from].pose, graph.vertices[edge.to].pose);
      const double best = best_switch(form, e.dot(edge.information * e), 2);
      EXPECT_NEAR(graph.switches[edge.switch_index].value, best, 1e-9);
    }
  }
}

TEST(Switchable, EdgesThatShareASwitchStandOrFallTogether) {
  auto [graph, truth] = square_drive();
  graph.switches.push_back({1, 1});
  graph.edges.back().switch_index = 0;
  Edge fine = graph.edges[graph.edges.size() - 2];
  fine.switch_index = 0;
  graph.edges.push_back(fine);
  SolverConfig config;
  config.max_iterations = 100;
  make_schur_solver()->solve(graph, config);
  EXPECT_EQ(graph.switches[0].value, 0);
}

}  // namespace
}  // namespace lanefuse
