// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/window_graph.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "graph/random_window.hpp"
#include "graph/window_conversion.hpp"

namespace lanefuse {
namespace {

using testing::WindowMaker;
using Id = WindowGraph::Id;

TEST(WindowGraph, IsAPoseGraphOfTheSameCost) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    WindowMaker maker(testing::any_shape(seed));
    const WindowGraph window = maker.make();
    PoseGraph graph;
    copy(window, graph);
    EXPECT_EQ(graph.vertices.size(), window.chain().size() + window.landmark_count());
    EXPECT_EQ(graph.edges.size(),
              window.chain().size() - 1 + window.observation_count() + window.tie_count());
    WindowOfGraph back;
    ASSERT_TRUE(to_window(graph, back));
    PoseGraph again;
    copy(back.window, again);
    EXPECT_NEAR(chi_squared(again), chi_squared(graph), 1e-9 * chi_squared(graph)) << seed;
  }
}

TEST(WindowGraph, KeepsTheInformationOfAnObservationInItsOwnFrame) {
  WindowMaker maker({.seed = 1});
  for (int i = 0; i < 50; ++i) {
    const PlanarInformation own = maker.planar_information();
    WindowGraph window;
    const Id pose = window.append_pose({5, 6, maker.uniform(-4, 4)}, {}, Eigen::Matrix3d::Zero());
    const Id landmark = window.add_landmark({8, 9, maker.uniform(-4, 4)});
    window.observe(pose, landmark, {3, 3, maker.uniform(-4, 4)}, own, 1);
    PoseGraph graph;
    copy(window, graph);
    const Eigen::Matrix3d& m = graph.edges.at(0).information;
    EXPECT_NEAR(m(0, 0), own.xx, 1e-9);
    EXPECT_NEAR(m(0, 1), own.xy, 1e-9);
    EXPECT_NEAR(m(1, 1), own.yy, 1e-9);
    EXPECT_NEAR(m(2, 2), own.heading, 1e-9);
    EXPECT_EQ(m(0, 2), 0);
  }
}

TEST(PlanarInformation, TurnsWithItsAxes) {
  const PlanarInformation along{1, 0, 100, 7};
  const PlanarInformation across = turned(along, std::numbers::pi / 2);
  EXPECT_NEAR(across.xx, 100, 1e-12);
  EXPECT_NEAR(across.yy, 1, 1e-12);
  EXPECT_NEAR(across.xy, 0, 1e-12);
  EXPECT_EQ(across.heading, 7);
  const PlanarInformation between = turned(along, 0.6);
  const Eigen::Matrix2d expected =
      rotation(0.6) * Eigen::Vector2d(1, 100).asDiagonal() * rotation(0.6).transpose();
  EXPECT_NEAR(between.xx, expected(0, 0), 1e-12);
  EXPECT_NEAR(between.xy, expected(0, 1), 1e-12);
  EXPECT_NEAR(between.yy, expected(1, 1), 1e-12);
}

TEST(WindowGraph, LooksTimeAndAgainFromOnePlaceAndKnowsNoMoreThanTheLastTime) {
  WindowMaker maker({.seed = 1});
  WindowGraph window;
  const Id pose = window.append_pose({}, {}, Eigen::Matrix3d::Zero());
  const Id landmark = window.add_landmark({});
  PlanarInformation own;
  for (int i = 0; i < 100'000; ++i) {
    own = maker.planar_information();
    window.observe(pose, landmark, {30, maker.uniform(-3, 3), maker.uniform(-3, 3)}, own, 1);
  }
  const PlanarInformation& known = window.observed_information(landmark);
  EXPECT_NEAR(known.xx, own.xx, 1e-8);
  EXPECT_NEAR(known.xy, own.xy, 1e-8);
  EXPECT_NEAR(known.yy, own.yy, 1e-8);
  EXPECT_NEAR(known.heading, own.heading, 1e-7);
  EXPECT_EQ(window.observation_count(landmark), 1U);
}

}  // namespace
}  // namespace lanefuse
