// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "graph/random_graph.hpp"
#include "graph/solver.hpp"

namespace lanefuse {
namespace {

using testing::GraphMaker;
using testing::GraphShape;

double farthest_from(const std::vector<Pose2>& truth, const PoseGraph& graph) {
  double farthest = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    const Pose2 apart = truth[v].inverse() * graph.vertices[v].pose;
    farthest = std::max({farthest, std::abs(apart.x), std::abs(apart.y), std::abs(apart.heading)});
  }
  return farthest;
}

GraphShape some_shape(double noise) {
  GraphShape shape;
  shape.seed = *rc::gen::arbitrary<unsigned>();
  shape.poses = *rc::gen::inRange<std::size_t>(1, 30);
  shape.landmarks = *rc::gen::inRange<std::size_t>(0, 60);
  shape.ties = *rc::gen::inRange<std::size_t>(0, 60);
  shape.loops = *rc::gen::inRange<std::size_t>(0, 10);
  shape.noise = noise;
  return shape;
}

/// One Gauss-Newton step by the book: Jacobians of linearize(), one dense matrix of everything, no
/// elimination.
std::vector<Pose2> after_one_plain_step(const PoseGraph& graph) {
  const auto side = static_cast<Eigen::Index>(3 * graph.vertices.size());
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(side, side);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(side);
  for (const Edge& edge : graph.edges) {
    const auto lin = linearize(edge, graph.vertices[edge.from].pose, graph.vertices[edge.to].pose);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, side);
    jacobian.middleCols<3>(3 * edge.from) = lin.from_jacobian;
    jacobian.middleCols<3>(3 * edge.to) = lin.to_jacobian;
    hessian += jacobian.transpose() * edge.information * jacobian;
    gradient += jacobian.transpose() * edge.information * lin.error;
  }
  std::vector<Pose2> result;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    if (!graph.vertices[v].fixed) continue;
    const auto first = static_cast<Eigen::Index>(3 * v);
    hessian.middleRows<3>(first).setZero();
    hessian.middleCols<3>(first).setZero();
    hessian.block<3, 3>(first, first).setIdentity();
    gradient.segment<3>(first).setZero();
  }
  const Eigen::VectorXd step = hessian.ldlt().solve(-gradient);
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    const Eigen::Vector3d own = step.segment<3>(static_cast<Eigen::Index>(3 * v));
    const Pose2& pose = graph.vertices[v].pose;
    result.push_back({pose.x + own.x(), pose.y + own.y(), wrap_angle(pose.heading + own.z())});
  }
  return result;
}

void expect_plain_step(const GraphShape& shape) {
  PoseGraph graph = GraphMaker(shape).make();
  const std::vector<Pose2> expected = after_one_plain_step(graph);
  SolverConfig config;
  config.max_iterations = 1;
  ASSERT_TRUE(make_schur_solver()->solve(graph, config).ok());
  EXPECT_LT(farthest_from(expected, graph), 1e-7);
}

RC_GTEST_PROP(SchurSolver, RecoversTheTruthFromExactMeasurements, ()) {
  GraphMaker maker(some_shape(0));
  PoseGraph graph = maker.make();
  SolverConfig config;
  config.max_iterations = 50;
  const SolveResult result = make_schur_solver()->solve(graph, config);
  RC_ASSERT(result.status == SolveStatus::converged);
  RC_ASSERT(result.final_chi2 < 1e-10);
  RC_ASSERT(farthest_from(maker.truth(), graph) < 1e-6);
}

RC_GTEST_PROP(SchurSolver, TakesThePlainGaussNewtonStep, ()) {
  PoseGraph graph = GraphMaker(some_shape(0.1)).make();
  const std::vector<Pose2> expected = after_one_plain_step(graph);
  SolverConfig config;
  config.max_iterations = 1;
  const SolveResult result = make_schur_solver()->solve(graph, config);
  RC_ASSERT(result.ok());
  RC_PRE(result.final_chi2 < result.initial_chi2);
  RC_ASSERT(farthest_from(expected, graph) < 1e-7);
}

TEST(SchurSolver, TakesThePlainStepWithSparsePosesAndLongLadders) {
  expect_plain_step({.seed = 3, .poses = 230, .landmarks = 60, .ties = 90, .loops = 5, .noise = 0.05});
}

TEST(SchurSolver, TakesThePlainStepWithOneLargeLadder) {
  expect_plain_step({.seed = 4, .poses = 60, .landmarks = 120, .ties = 400, .loops = 0, .noise = 0.05});
}

TEST(SchurSolver, RolesAreHintsThatDoNotMoveTheOptimum) {
  PoseGraph eliminated = GraphMaker({.seed = 5, .noise = 0.2}).make();
  PoseGraph plain = eliminated;
  PoseGraph turned_around = eliminated;
  for (Vertex& v : plain.vertices) v.role = VertexRole::pose;
  for (Vertex& v : turned_around.vertices) {
    v.role = v.role == VertexRole::pose ? VertexRole::landmark : VertexRole::pose;
  }
  SolverConfig config;
  config.max_iterations = 50;
  const double chi2 = make_schur_solver()->solve(eliminated, config).final_chi2;
  EXPECT_NEAR(make_schur_solver()->solve(plain, config).final_chi2, chi2, 1e-8 * chi2);
  EXPECT_NEAR(make_schur_solver()->solve(turned_around, config).final_chi2, chi2, 1e-8 * chi2);
}

TEST(SchurSolver, AFixedLandmarkHoldsTheGaugeAsWell) {
  GraphMaker maker({.seed = 6});
  PoseGraph graph = maker.make();
  for (Vertex& v : graph.vertices) v.fixed = false;
  graph.vertices.back().fixed = true;
  graph.vertices.back().pose = maker.truth().back();
  SolverConfig config;
  config.max_iterations = 50;
  EXPECT_EQ(make_schur_solver()->solve(graph, config).status, SolveStatus::converged);
  EXPECT_LT(farthest_from(maker.truth(), graph), 1e-6);
}

TEST(SchurSolver, ReportsChiSquaredOfWhatItLeaves) {
  PoseGraph graph = GraphMaker({.seed = 7, .noise = 0.2}).make();
  const double before = chi_squared(graph);
  const SolveResult result = make_schur_solver()->solve(graph, {});
  EXPECT_NEAR(result.initial_chi2, before, 1e-9 * before);
  EXPECT_NEAR(result.final_chi2, chi_squared(graph), 1e-9 * result.final_chi2);
  EXPECT_LT(result.final_chi2, result.initial_chi2);
  EXPECT_EQ(result.iterations, 2);
}

TEST(SchurSolver, AWorkspaceUsedBeforeGivesTheSameBits) {
  const PoseGraph start = GraphMaker({.seed = 8, .noise = 0.2}).make();
  const auto used = make_schur_solver();
  PoseGraph larger = GraphMaker({.seed = 9, .poses = 250, .landmarks = 40}).make();
  used->solve(larger, {});
  PoseGraph by_used = start;
  PoseGraph by_fresh = start;
  used->solve(by_used, {});
  make_schur_solver()->solve(by_fresh, {});
  for (std::size_t v = 0; v < start.vertices.size(); ++v) {
    EXPECT_EQ(by_used.vertices[v].pose, by_fresh.vertices[v].pose);
  }
}

TEST(SchurSolver, NeverEndsAboveItsStart) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    PoseGraph graph = GraphMaker({.seed = seed, .poses = 40, .noise = 0.5, .start_error = 25}).make();
    const double before = chi_squared(graph);
    SolverConfig config;
    config.max_iterations = 1 + static_cast<int>(seed);
    const SolveResult result = make_schur_solver()->solve(graph, config);
    ASSERT_TRUE(result.ok());
    EXPECT_LE(chi_squared(graph), before * (1 + 1e-12));
    EXPECT_NEAR(result.final_chi2, chi_squared(graph), 1e-9 * before);
  }
}

TEST(SchurSolver, NothingFreeIsNothingToDo) {
  PoseGraph graph;
  graph.vertices.push_back({{1, 2, 3}, VertexRole::pose, true});
  EXPECT_EQ(make_schur_solver()->solve(graph, {}).status, SolveStatus::converged);
  EXPECT_EQ(graph.vertices[0].pose, (Pose2{1, 2, 3}));
}

}  // namespace
}  // namespace lanefuse
