// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Windows that cannot be solved are told by name, and left bit by bit as they were.
#include <limits>

#include <gtest/gtest.h>

#include "graph/random_window.hpp"
#include "graph/window_solver.hpp"

namespace lanefuse {
namespace {

using testing::bits;
using testing::WindowMaker;
using testing::WindowShape;
using Id = WindowGraph::Id;

constexpr double kBad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};

WindowGraph sound_window() { return WindowMaker(WindowShape{.seed = 3}).make(); }

/// The result of a solution, having seen that failure left every bit where it was.
SolveResult solved(WindowGraph& window) {
  const auto before = bits(window);
  SolverConfig config;
  config.max_iterations = 20;
  ConjugateGradientSolver solver;
  const SolveResult result = solver.solve(window, config);
  if (!result.ok()) {
    EXPECT_EQ(bits(window), before);
    EXPECT_TRUE(result.final_chi2 == result.initial_chi2 || std::isnan(result.initial_chi2));
  }
  return result;
}

SolveStatus status_of(WindowGraph window) { return solved(window).status; }

Id first_tied(const WindowGraph& window) {
  Id id = 0;
  while (window.first_tie(id) == WindowGraph::kNone) ++id;
  return id;
}

TEST(WindowFailure, TheWindowTheOthersSpoilIsSound) {
  EXPECT_EQ(status_of(sound_window()), SolveStatus::converged);
}

TEST(WindowFailure, NothingHasNoPoseThatIsHeld) {
  EXPECT_EQ(status_of(WindowGraph{}), SolveStatus::no_fixed_vertex);
  WindowGraph cleared = sound_window();
  cleared.clear();
  EXPECT_EQ(status_of(cleared), SolveStatus::no_fixed_vertex);
}

TEST(WindowFailure, PosesThatAreNoNumbers) {
  for (const double bad : kBad) {
    for (const std::size_t k : {0U, 4U, 11U}) {
      for (const Pose2& pose : {Pose2{bad, 0, 0}, Pose2{0, bad, 0}, Pose2{0, 0, bad}}) {
        WindowGraph window = sound_window();
        window.place_pose(window.chain()[k], pose);
        EXPECT_EQ(status_of(window), SolveStatus::not_finite) << k;
      }
    }
  }
}

TEST(WindowFailure, LandmarksThatAreNowhere) {
  for (const double bad : kBad) {
    WindowGraph window = sound_window();
    window.place_landmark(5, {1, bad, 0});
    EXPECT_EQ(status_of(window), SolveStatus::not_finite);
    window = sound_window();
    window.place_landmark(first_tied(window), {1, 0, bad});
    EXPECT_EQ(status_of(window), SolveStatus::not_finite);
  }
}

TEST(WindowFailure, MeasurementsThatAreNoNumbers) {
  for (const double bad : kBad) {
    WindowGraph window = sound_window();
    window.observe(window.chain()[2], 5, {bad, 0, 0}, {1, 0, 1, 1}, 99);
    EXPECT_EQ(status_of(window), SolveStatus::not_finite);
    window = sound_window();
    window.observe(window.chain()[2], 5, {0, 0, bad}, {1, 0, 1, 1}, 99);
    EXPECT_EQ(status_of(window), SolveStatus::not_finite);
    window = sound_window();
    window.observe(window.chain()[2], 5, {3, 4, 0}, {1, 0, bad, 1}, 99);
    EXPECT_EQ(status_of(window), SolveStatus::not_finite);
    window = sound_window();
    window.append_pose({0, 0, 0}, {bad, 0, 0}, Eigen::Matrix3d::Identity());
    EXPECT_EQ(status_of(window), SolveStatus::not_finite);
  }
}

TEST(WindowFailure, TiesThatAreNoNumbers) {
  for (const double bad : kBad) {
    for (const double prior : {0.0, 2.0}) {
      WindowGraph window = sound_window();
      WindowGraph::Tie tie;
      tie.from = 1;
      tie.to = 2;
      tie.kind = 9;
      tie.switch_prior = prior;
      tie.measurement = {0, bad, 0};
      ASSERT_NE(window.add_tie(tie, Eigen::Matrix3d::Identity(), true), WindowGraph::kNone);
      EXPECT_EQ(status_of(window), SolveStatus::not_finite) << bad << ' ' << prior;
    }
  }
}

TEST(WindowFailure, NumbersThatOverflowOnTheWay) {
  WindowGraph window = sound_window();
  window.place_pose(window.chain()[2], {1e200, 0, 0});
  EXPECT_EQ(status_of(window), SolveStatus::not_finite);
}

TEST(WindowFailure, LandmarksThatNothingHolds) {
  WindowGraph window = sound_window();
  const Id alone = window.add_landmark({1, 2, 0.3});
  EXPECT_EQ(status_of(window), SolveStatus::singular);
  // A second one tied to the first: each is determined by the other, both by nothing.
  WindowGraph::Tie tie;
  tie.from = alone;
  tie.to = window.add_landmark({4, 2, 0.1});
  tie.measurement = {3, 0, 0};
  window.add_tie(tie, Eigen::Matrix3d::Identity(), true);
  EXPECT_EQ(status_of(window), SolveStatus::singular);
}

TEST(WindowFailure, ALandmarkOfWhichNothingIsTold) {
  for (const PlanarInformation& little :
       {PlanarInformation{0, 0, 0, 0}, PlanarInformation{0, 0, 100, 10}, PlanarInformation{10, 0, 0, 10},
        PlanarInformation{10, 10, 10, 10}, PlanarInformation{10, 0, 10, 0}}) {
    for (const double heading : {0.0, 0.7, -2.9}) {
      WindowGraph window = sound_window();
      const Id landmark = window.add_landmark({1, 2, 0.3});
      window.observe(window.chain()[3], landmark, {5, 3, heading}, little, 1);
      window.observe(window.chain()[3], landmark, {5, 3, heading}, little, 2);
      EXPECT_EQ(status_of(window), SolveStatus::singular) << heading;
    }
  }
}

TEST(WindowFailure, ATieTellsOfALandmarkWhatItsObservationsLeaveOpen) {
  WindowGraph window = sound_window();
  const Id landmark = window.add_landmark({1, 2, 0.3});
  window.observe(window.chain()[3], landmark, {5, 3, 0}, {0, 0, 100, 10}, 1);
  WindowGraph::Tie tie;
  tie.from = 2;
  tie.to = landmark;
  tie.kind = 7;
  window.add_tie(tie, Eigen::Matrix3d::Identity(), true);
  EXPECT_EQ(status_of(window), SolveStatus::converged);
}

TEST(WindowFailure, ASwitchedOffTieDeterminesNothing) {
  WindowGraph window = sound_window();
  WindowGraph::Tie tie;
  tie.from = 2;
  tie.to = window.add_landmark({500, 2, 0.3});
  tie.kind = 7;
  tie.switch_prior = 1;
  window.add_tie(tie, Eigen::Matrix3d::Identity(), true);
  EXPECT_EQ(status_of(window), SolveStatus::singular);
}

TEST(WindowFailure, APoseAloneIsNoFailure) {
  WindowGraph window;
  window.append_pose({1, 2, 3}, {}, Eigen::Matrix3d::Zero());
  EXPECT_EQ(status_of(window), SolveStatus::converged);
  const Id landmark = window.add_landmark({});
  window.observe(window.chain()[0], landmark, {4, 0, 0.1}, {1, 0, 100, 1000}, 1);
  ASSERT_EQ(solved(window).status, SolveStatus::converged);
  const Pose2 off = (Pose2{1, 2, 3} * Pose2{4, 0, 0.1}).inverse() * window.landmark(landmark);
  EXPECT_LT(Eigen::Vector3d(off.x, off.y, off.heading).norm(), 1e-12);
}

TEST(WindowFailure, PosesThatObserveNothingAreHeldByTheirSteps) {
  WindowGraph window = WindowMaker({.seed = 1, .poses = 500, .landmarks = 0, .start_error = 1}).make();
  const SolveResult result = solved(window);
  EXPECT_EQ(result.status, SolveStatus::converged);
  EXPECT_EQ(result.fallback, SolveFallback::none);
  EXPECT_LT(result.final_chi2, 1e-9);
}

}  // namespace
}  // namespace lanefuse
