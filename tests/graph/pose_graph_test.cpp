// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/pose_graph.hpp"

#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "graph/random_graph.hpp"

namespace lanefuse {
namespace {

using testing::GraphMaker;

constexpr double kPi = std::numbers::pi;

/// An angle anywhere, but often within a hair of the wrap at +-pi.
double some_angle(GraphMaker& maker) {
  const double anywhere = maker.uniform(-kPi, kPi);
  return maker.uniform(0, 1) < 0.5 ? anywhere : wrap_angle(kPi + maker.uniform(-1e-3, 1e-3));
}

Pose2 some_pose(GraphMaker& maker) {
  return {maker.uniform(-40, 40), maker.uniform(-40, 40), some_angle(maker)};
}

Pose2 nudged(const Pose2& pose, int coordinate, double by) {
  return {pose.x + (coordinate == 0 ? by : 0), pose.y + (coordinate == 1 ? by : 0),
          wrap_angle(pose.heading + (coordinate == 2 ? by : 0))};
}

Eigen::Vector3d wrapped_difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.x() - b.x(), a.y() - b.y(), wrap_angle(a.z() - b.z())};
}

RC_GTEST_PROP(PoseGraph, JacobiansEqualCentralDifferences, (unsigned seed)) {
  GraphMaker maker({.seed = seed});
  Edge edge;
  edge.measurement = some_pose(maker);
  const Pose2 from = some_pose(maker);
  const Pose2 to = some_pose(maker);
  const Linearization exact = linearize(edge, from, to);
  RC_ASSERT(exact.error == error(edge, from, to));
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d by_from =
        wrapped_difference(error(edge, nudged(from, k, kStep), to), error(edge, nudged(from, k, -kStep), to));
    const Eigen::Vector3d by_to =
        wrapped_difference(error(edge, from, nudged(to, k, kStep)), error(edge, from, nudged(to, k, -kStep)));
    RC_ASSERT((by_from / (2 * kStep) - exact.from_jacobian.col(k)).norm() < 1e-6);
    RC_ASSERT((by_to / (2 * kStep) - exact.to_jacobian.col(k)).norm() < 1e-6);
  }
}

RC_GTEST_PROP(PoseGraph, ErrorIsTheLogOfTheClosedCycle, (unsigned seed)) {
  GraphMaker maker({.seed = seed});
  Edge edge;
  edge.measurement = some_pose(maker);
  const Pose2 from = some_pose(maker);
  const Pose2 to = some_pose(maker);
  const Pose2 cycle = edge.measurement.inverse() * (from.inverse() * to);
  const Eigen::Vector3d expected(cycle.x, cycle.y, cycle.heading);
  RC_ASSERT(wrapped_difference(error(edge, from, to), expected).norm() < 1e-10);
}

TEST(PoseGraph, ErrorTakesTheShortWayAroundTheWrap) {
  Edge edge;
  edge.measurement = {0, 0, 0.02};
  const Eigen::Vector3d e = error(edge, {0, 0, kPi - 0.005}, {0, 0, -kPi + 0.005});
  EXPECT_NEAR(e.z(), -0.01, 1e-12);
}

RC_GTEST_PROP(PoseGraph, ChiSquaredIgnoresWhereTheWholeGraphLies, (unsigned seed)) {
  GraphMaker maker({.seed = seed, .noise = 0.3});
  PoseGraph graph = maker.make();
  const double here = chi_squared(graph);
  const Pose2 elsewhere_from_here = some_pose(maker);
  for (Vertex& v : graph.vertices) v.pose = elsewhere_from_here * v.pose;
  RC_ASSERT(std::abs(chi_squared(graph) - here) < 1e-8 * here);
}

TEST(PoseGraph, ChiSquaredCountsSwitchedTermsAndPriors) {
  PoseGraph graph;
  graph.vertices.resize(2);
  graph.vertices[1].pose = {2, 0, 0};
  Edge edge;
  edge.to = 1;
  edge.switch_index = 0;
  graph.edges.push_back(edge);
  graph.switches.push_back({3, 0.25});
  EXPECT_DOUBLE_EQ(chi_squared(graph, SwitchForm::linear), 0.25 * 4 + 3 * 0.75 * 0.75);
  EXPECT_DOUBLE_EQ(chi_squared(graph, SwitchForm::squared), 0.0625 * 4 + 3 * 0.75 * 0.75);
}

}  // namespace
}  // namespace lanefuse
