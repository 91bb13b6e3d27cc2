// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/window_solver.hpp"

#include <gtest/gtest.h>

#include "graph/random_window.hpp"
#include "graph/window_conversion.hpp"

namespace lanefuse {
namespace {

using testing::any_shape;
using testing::WindowMaker;
using testing::WindowShape;

constexpr SwitchForm kForms[] = {SwitchForm::linear, SwitchForm::squared};

PoseGraph copied(const WindowGraph& window) {
  PoseGraph graph;
  copy(window, graph);
  return graph;
}

/// How far apart the vertices of two copies of a window are, at most [m, rad].
double farthest_apart(const PoseGraph& a, const PoseGraph& b) {
  double farthest = 0;
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    const Pose2& p = a.vertices[v].pose;
    const Pose2& q = b.vertices[v].pose;
    const double off =
        std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(wrap_angle(p.heading - q.heading))});
    farthest = std::max(farthest, off);
  }
  return farthest;
}

SolverConfig to_the_end(SwitchForm form) {
  SolverConfig config;
  config.max_iterations = 300;
  config.relative_tolerance = 1e-12;
  config.switch_form = form;
  return config;
}

/// What two costs that are the same may differ by.
double rounding(double chi2) { return 1e-9 * chi2 + 1e-12; }

/// Both solvers from one start, by steps that are as good as exact.
void expect_same_optimum(const WindowShape& shape, SwitchForm form, double position, int& fallbacks) {
  WindowGraph window = WindowMaker(shape).make();
  PoseGraph direct = copied(window);
  SolverConfig config = to_the_end(form);
  config.cg_tolerance = 1e-10;
  config.max_cg_iterations = 1000;
  const SolveResult expected = make_schur_solver()->solve(direct, config);
  ConjugateGradientSolver solver;
  const SolveResult result = solver.solve(window, config);
  ASSERT_EQ(result.status, SolveStatus::converged) << shape.seed;
  ASSERT_EQ(expected.status, SolveStatus::converged) << shape.seed;
  if (result.fallback != SolveFallback::none) ++fallbacks;
  EXPECT_NEAR(result.initial_chi2, expected.initial_chi2, rounding(expected.initial_chi2)) << shape.seed;
  EXPECT_NEAR(result.final_chi2, expected.final_chi2, rounding(expected.final_chi2)) << shape.seed;
  EXPECT_NEAR(chi_squared(copied(window), form), result.final_chi2, rounding(result.final_chi2))
      << shape.seed;
  EXPECT_LT(farthest_apart(copied(window), direct), position) << shape.seed;
}

TEST(ConjugateGradientSolver, ReachesTheOptimumOfTheDirectSolver) {
  int fallbacks = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    for (const SwitchForm form : kForms) expect_same_optimum(any_shape(seed), form, 1e-6, fallbacks);
  }
  EXPECT_LE(fallbacks, 6) << "the direct solver beside itself shows nothing";
}

TEST(ConjugateGradientSolver, ReachesItAMillionMetresAwayToo) {
  int fallbacks = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    WindowShape shape = any_shape(seed);
    shape.origin.x += 1e6;
    shape.origin.y -= 1e6;
    for (const SwitchForm form : kForms) expect_same_optimum(shape, form, 1e-6, fallbacks);
  }
  EXPECT_LE(fallbacks, 4);
}

TEST(ConjugateGradientSolver, EndsWhereTheDirectSolverFindsNothingBetterByItsRoughStepsToo) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    for (const SwitchForm form : kForms) {
      WindowGraph window = WindowMaker(any_shape(seed)).make();
      ConjugateGradientSolver solver;
      const SolveResult result = solver.solve(window, to_the_end(form));
      ASSERT_EQ(result.status, SolveStatus::converged) << seed;
      PoseGraph direct = copied(window);
      const SolveResult better = make_schur_solver()->solve(direct, to_the_end(form));
      EXPECT_LE(result.final_chi2 - better.final_chi2, rounding(result.final_chi2)) << seed;
      EXPECT_LT(farthest_apart(copied(window), direct), 1e-6) << seed;
    }
  }
}

TEST(ConjugateGradientSolver, LeavesAHundredThousandthOfTheCostInTwoWarmIterations) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    WindowShape shape = any_shape(seed);
    shape.wrong = 0;  // no switch on the brink: as a window is that was solved a cycle ago
    WindowGraph window = WindowMaker(shape).make();
    ConjugateGradientSolver solver;
    solver.solve(window, to_the_end(SwitchForm::linear));
    WindowMaker shaker({.seed = seed});
    for (const WindowGraph::Id id : window.chain().first(window.chain().size() - 1)) {
      const Pose2 p = window.pose(id);
      window.place_pose(id, {p.x + shaker.uniform(-0.02, 0.02), p.y + shaker.uniform(-0.02, 0.02),
                             p.heading + shaker.uniform(-0.002, 0.002)});
    }
    const SolveResult warm = solver.solve(window, {});
    EXPECT_EQ(warm.fallback, SolveFallback::none) << seed;
    EXPECT_LE(warm.iterations, 2);
    const double optimum = solver.solve(window, to_the_end(SwitchForm::linear)).final_chi2;
    EXPECT_LE(warm.final_chi2 - optimum, 1e-5 * warm.initial_chi2) << seed;
  }
}

TEST(ConjugateGradientSolver, NeedsNoHelpWhereAllFitsToTheLastBit) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    WindowShape shape = any_shape(seed);
    shape.noise = shape.wrong = 0;
    WindowGraph window = WindowMaker(shape).make();
    ConjugateGradientSolver solver;
    for (int cycle = 0; cycle < 5; ++cycle) {
      const SolveResult result = solver.solve(window, to_the_end(SwitchForm::linear));
      EXPECT_EQ(result.status, SolveStatus::converged) << seed;
      EXPECT_EQ(result.fallback, SolveFallback::none) << seed;
      if (cycle > 0) {
        EXPECT_EQ(result.halvings, 0) << seed;
      }
      EXPECT_LT(result.final_chi2, 1e-12) << seed;
    }
  }
}

TEST(ConjugateGradientSolver, HoldsTheNewestPoseAndNeverEndsHigher) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    for (const int iterations : {0, 1, 2, 3}) {
      WindowGraph window = WindowMaker(any_shape(seed)).make();
      const Pose2 newest = window.pose(window.chain().back());
      ConjugateGradientSolver solver;
      SolverConfig config;
      config.max_iterations = iterations;
      const SolveResult result = solver.solve(window, config);
      ASSERT_TRUE(result.ok());
      EXPECT_EQ(window.pose(window.chain().back()), newest);
      EXPECT_LE(result.final_chi2, result.initial_chi2);
      EXPECT_NEAR(chi_squared(copied(window)), result.final_chi2, rounding(result.final_chi2)) << seed;
    }
  }
}

TEST(ConjugateGradientSolver, HasTheRightAnswerFoundWhereItMayNotIterate) {
  for (const int iterations : {0, 1}) {
    int struggled = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
      WindowShape shape = any_shape(seed);
      shape.poses += 4;
      shape.landmarks += 10;
      WindowGraph window = WindowMaker(shape).make();
      PoseGraph direct = copied(window);
      SolverConfig config = to_the_end(SwitchForm::linear);
      config.cg_tolerance = 1e-6;
      config.max_cg_iterations = iterations;
      make_schur_solver()->solve(direct, config);
      ConjugateGradientSolver solver;
      const SolveResult result = solver.solve(window, config);
      EXPECT_EQ(result.status, SolveStatus::converged);
      EXPECT_LT(farthest_apart(copied(window), direct), 1e-9) << seed;
      if (result.fallback == SolveFallback::cg_struggled) ++struggled;
    }
    EXPECT_GE(struggled, iterations == 0 ? 30 : 20)
        << "one will do where each landmark is seen from one pose";
  }
}

TEST(ConjugateGradientSolver, GivesTheSameBytesWhateverItSolvedBefore) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const WindowGraph start = WindowMaker(any_shape(seed)).make();
    const auto solved_by = [&](ConjugateGradientSolver& solver) {
      WindowGraph window = start;
      solver.solve(window, {});
      return testing::bits(window);
    };
    ConjugateGradientSolver solver;
    const auto first = solved_by(solver);
    EXPECT_EQ(first, solved_by(solver));
    WindowGraph other = WindowMaker(any_shape(seed + 500)).make();
    solver.solve(other, to_the_end(SwitchForm::squared));
    EXPECT_EQ(first, solved_by(solver));
    ConjugateGradientSolver fresh;
    EXPECT_EQ(first, solved_by(fresh));
  }
}

TEST(WindowSolver, IsAlsoAnyGraphSolverOnACopy) {
  const auto copying = make_window_solver(make_schur_solver());
  for (unsigned seed = 0; seed < 20; ++seed) {
    WindowGraph window = WindowMaker(any_shape(seed)).make();
    PoseGraph direct = copied(window);
    const SolveResult expected = make_schur_solver()->solve(direct, {});
    EXPECT_EQ(copying->solve(window, {}).final_chi2, expected.final_chi2);
    EXPECT_EQ(farthest_apart(copied(window), direct), 0);
    for (const Switch& s : copied(window).switches) EXPECT_GE(s.value, 0);
  }
}

}  // namespace
}  // namespace lanefuse
