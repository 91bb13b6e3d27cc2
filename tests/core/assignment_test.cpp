// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/assignment.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

struct Problem {
  int rows = 0;
  int columns = 0;
  std::vector<double> costs;
  double skip = 0;

  [[nodiscard]] double cost(int row, int column) const {
    return costs[static_cast<std::size_t>(row * columns + column)];
  }
};

/// The least cost of all assignments of `row` and those below it, found by trying each of them.
double least_cost(const Problem& problem, int row, std::vector<char>& taken) {
  if (row == problem.rows) return 0;
  double least = problem.skip + least_cost(problem, row + 1, taken);
  for (int column = 0; column < problem.columns; ++column) {
    char& is_taken = taken[static_cast<std::size_t>(column)];
    if (is_taken != 0) continue;
    is_taken = 1;
    least = std::min(least, problem.cost(row, column) + least_cost(problem, row + 1, taken));
    is_taken = 0;
  }
  return least;
}

double cost_of(const Problem& problem, std::span<const int> columns) {
  double sum = 0;
  std::set<int> taken;
  for (int row = 0; row < problem.rows; ++row) {
    const int column = columns[static_cast<std::size_t>(row)];
    if (column != Assignment::kAlone) {
      EXPECT_TRUE(taken.insert(column).second);
    }
    sum += column == Assignment::kAlone ? problem.skip : problem.cost(row, column);
  }
  return sum;
}

Problem draw_problem(std::mt19937& random) {
  std::uniform_int_distribution<int> size(0, 6);
  std::uniform_int_distribution<int> whole(-6, 12);
  std::uniform_real_distribution<double> real(-1, 3);
  Problem problem{.rows = size(random), .columns = size(random)};
  const bool with_ties = whole(random) > 3;
  for (int pair = 0; pair < problem.rows * problem.columns; ++pair) {
    const bool forbidden = whole(random) > 8;
    const double cost = with_ties ? whole(random) : real(random);
    problem.costs.push_back(forbidden ? Assignment::kForbidden : cost);
  }
  problem.skip = with_ties ? whole(random) : real(random);
  return problem;
}

TEST(Assignment, CostsAsLittleAsTheBestOfAllAssignments) {
  std::mt19937 random(7);
  Assignment assignment;
  for (int trial = 0; trial < 3000; ++trial) {
    const Problem problem = draw_problem(random);
    std::vector<char> taken(static_cast<std::size_t>(problem.columns), 0);
    const double best = least_cost(problem, 0, taken);
    const auto columns = assignment.solve(problem.rows, problem.columns, problem.costs, problem.skip);
    ASSERT_EQ(columns.size(), static_cast<std::size_t>(problem.rows));
    ASSERT_NEAR(cost_of(problem, columns), best, 1e-9) << "trial " << trial;
  }
}

TEST(Assignment, GivesUpTheNearestPairWhereTheWholeGains) {
  Assignment assignment;
  const auto columns = assignment.solve(2, 2, std::vector<double>{1, 2, 2, 9}, 100);
  EXPECT_EQ(columns[0], 1);
  EXPECT_EQ(columns[1], 0);
}

TEST(Assignment, LeavesRowsAloneThatOnlyHaveForbiddenOrDearColumns) {
  Assignment assignment;
  const double never = Assignment::kForbidden;
  const auto columns = assignment.solve(3, 2, std::vector<double>{never, never, 7, 6, never, 1}, 5);
  EXPECT_EQ(columns[0], Assignment::kAlone);
  EXPECT_EQ(columns[1], Assignment::kAlone);
  EXPECT_EQ(columns[2], 1);
}

TEST(Assignment, AsksACostFunctionOnceAPair) {
  Assignment assignment;
  int asked = 0;
  const auto cost = [&asked](int row, int column) {
    ++asked;
    return row == column ? 0.0 : 1.0;
  };
  const auto columns = assignment.solve(4, 5, cost, 10);
  EXPECT_EQ(asked, 20);
  for (int row = 0; row < 4; ++row) EXPECT_EQ(columns[static_cast<std::size_t>(row)], row);
}

TEST(Assignment, TakesAFullMotorwayOfTracks) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 100);
  constexpr int kSize = 120;
  std::vector<double> truth;
  for (int index = 0; index < kSize; ++index) truth.push_back(place(random));
  Assignment assignment;
  const auto cost = [&](int row, int column) {
    const double distance = truth[static_cast<std::size_t>(row)] - truth[static_cast<std::size_t>(column)];
    return distance * distance;
  };
  const auto columns = assignment.solve(kSize, kSize, cost, 1e6);
  for (int row = 0; row < kSize; ++row) EXPECT_EQ(columns[static_cast<std::size_t>(row)], row);
}

}  // namespace
}  // namespace lanefuse
