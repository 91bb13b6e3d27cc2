// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/road_state.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

constexpr double kPeriod = 0.04;  ///< [s]

/// A state that knows a bend and a few lines, and is sure of nothing.
RoadState state_in_bend(double curvature, double heading = 0) {
  RoadState state{RoadConfig{}};
  for (int k = 0; k < RoadAxis::kKnots; ++k) state.numbers().set_mean(kCurvatures + k, curvature);
  state.numbers().set_mean(kHeading, heading);
  for (const double offset : {5.4, 1.8, -1.8}) state.add_line(offset, 0.3);
  state.rebuild_axis();
  return state;
}

/// What the step does to the mean, by trying it with number i a little more and a little less.
Eigen::VectorXd tried(const RoadState& state, const Pose2& step, int i, double by) {
  RoadState more = state;
  RoadState less = state;
  more.numbers().set_mean(i, state.numbers().mean(i) + by);
  less.numbers().set_mean(i, state.numbers().mean(i) - by);
  more.rebuild_axis();
  less.rebuild_axis();
  more.drive(step, kPeriod);
  less.drive(step, kPeriod);
  Eigen::VectorXd column(state.numbers().size());
  for (int j = 0; j < state.numbers().size(); ++j) {
    column[j] = (more.numbers().mean(j) - less.numbers().mean(j)) / (2 * by);
  }
  return column;
}

struct Step {
  const char* name;
  double heading;
  double curvature;
  Pose2 moved;
  double driven_before;
};

class Drive : public ::testing::TestWithParam<Step> {
 protected:
  static RoadState state() {
    RoadState state = state_in_bend(GetParam().curvature, 0);
    if (GetParam().driven_before > 0) state.drive({GetParam().driven_before, 0, 0}, kPeriod);
    state.numbers().set_mean(kHeading, GetParam().heading);
    state.rebuild_axis();
    return state;
  }
};

/// More variance of one number before the step makes, after it, the column of that number times itself.
TEST_P(Drive, MovesTheCovarianceAsTheMean) {
  const RoadState before = state();
  RoadState after = before;
  after.drive(GetParam().moved, kPeriod);
  const int size = before.numbers().size();
  for (int i = 0; i < size; ++i) {
    const double sigma = std::sqrt(before.numbers().variance(i));
    const Eigen::VectorXd column = tried(before, GetParam().moved, i, 1e-3 * sigma);
    RoadState surer = before;
    const double more = before.numbers().variance(i);
    surer.numbers().add_noise(i, more);
    surer.drive(GetParam().moved, kPeriod);
    for (int j = 0; j < size; ++j) {
      for (int k = 0; k <= j; ++k) {
        const double unit = std::sqrt(after.numbers().variance(j) * after.numbers().variance(k));
        const double grown = surer.numbers().covariance(j, k) - after.numbers().covariance(j, k);
        ASSERT_NEAR(grown / unit, more * column[j] * column[k] / unit, 2e-3) << i << ": " << j << ' ' << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, Drive,
                         ::testing::Values(Step{"Straight", 0, 0, {1.2, 0, 0}, 0},
                                           Step{"Bend", 0, 1e-3, {1.2, 7e-4, 1.2e-3}, 0},
                                           Step{"Aslant", 0.03, -5e-4, {1.4, 0.01, 0.002}, 0},
                                           Step{"OverAKnot", 0.01, 5e-4, {1.2, 0, 6e-4}, 14.5},
                                           Step{"OverAnOffsetKnot", 0.01, 5e-4, {1.2, 0, 6e-4}, 34.5}),
                         [](const auto& one) { return one.param.name; });

TEST(RoadState, AnArcIsFollowed) {
  constexpr double kCurvature = 1.0 / 500;
  RoadState state = state_in_bend(kCurvature);
  for (int cycle = 0; cycle < 500; ++cycle) {
    state.drive(constant_turn(30, 30 * kCurvature, kPeriod), kPeriod);
    ASSERT_NEAR(state.numbers().mean(kHeading), 0, 1e-3) << cycle;
    ASSERT_NEAR(state.offset(state.lines()[1], 0), 1.8, 0.03) << cycle;
    ASSERT_NEAR(state.offset(state.lines()[2], 80), -1.8, 0.03) << cycle;
    ASSERT_NEAR(state.numbers().mean(kCurvatures + 4), kCurvature, 1e-6);
  }
  EXPECT_NEAR(state.driven(), 600, 1);
}

TEST(RoadState, ALaneChangeMovesAllLinesAside) {
  RoadState state = state_in_bend(0);
  Pose2 car;
  const auto way = [](double seconds) { return 1.75 * (1 - std::cos(std::numbers::pi * seconds / 5)); };
  for (int cycle = 1; cycle <= 125; ++cycle) {
    const double t = cycle * kPeriod;
    const double slope = (way(t + 0.01) - way(t - 0.01)) / 0.02 / 30;
    const Pose2 next{30 * t, way(t), std::atan(slope)};
    state.drive(car.inverse() * next, kPeriod);
    car = next;
    ASSERT_NEAR(state.offset(state.lines()[0], 0), 5.4 - way(t), 0.01);
    ASSERT_NEAR(state.offset(state.lines()[0], 90), 5.4 - way(t), 0.01);
    ASSERT_NEAR(state.numbers().mean(kHeading), car.heading, 1e-4);
  }
  EXPECT_NEAR(state.offset(state.lines()[1], 0), 1.8 - 3.5, 0.01);
}

TEST(RoadState, AStandingCarDoesNotTurn) {
  RoadState state = state_in_bend(0, 0.01);
  const double sigma = std::sqrt(state.numbers().variance(kHeading));
  constexpr double kBias = 5e-4;  // [rad/s]
  for (int cycle = 0; cycle < 3000; ++cycle) state.drive({0, 0, kBias * kPeriod}, kPeriod);
  EXPECT_EQ(state.numbers().mean(kHeading), 0.01);
  EXPECT_NEAR(std::sqrt(state.numbers().variance(kHeading)), sigma, 1e-9);
  EXPECT_NEAR(state.numbers().mean(kYawRateError), kBias, 1e-5) << "and its gyro's bias is learned";
  EXPECT_EQ(state.offset(state.lines()[1], 40), 1.8);
  EXPECT_EQ(state.driven(), 0);
}

/// What stands along the road stands still there while the car, and the knots with it, move on.
TEST(RoadState, KnotsMoveOverARoadThatStandsStill) {
  RoadState state = state_in_bend(0);
  const int first = state.lines()[1].first;
  for (int k = 0; k < RoadState::kOffsets; ++k) state.numbers().set_mean(first + k, 1.8 + 0.1 * k);
  for (int k = 0; k < RoadAxis::kKnots; ++k) state.numbers().set_mean(kCurvatures + k, 1e-7 * k);
  const double offset = state.offset(state.lines()[1], 115);
  state.rebuild_axis();
  const double curvature = state.axis().curvature_at(115);
  for (double driven = 0; driven < 96; driven += 1.2) {
    EXPECT_NEAR(state.offset(state.lines()[1], 115 - driven), offset, 5e-3) << driven;
    EXPECT_NEAR(state.axis().curvature_at(115 - driven), curvature, 1e-9) << driven;
    EXPECT_GT(state.first_knot(), -40);
    EXPECT_LE(state.first_knot(), -15);
    EXPECT_GT(state.first_offset(), -60);
    state.drive({1.2, 0, 0}, kPeriod);
  }
}

TEST(RoadState, ANewLinesOffsetsAreOnesOwn) {
  RoadState state = state_in_bend(0);
  const KnownLine* line = state.add_line_beside(state.lines()[0].id, -3.6, 0.2);
  ASSERT_NE(line, nullptr);
  EXPECT_NEAR(state.offset(*line, 70), 1.8, 1e-12);
  EXPECT_NEAR(state.numbers().variance(line->first), 0.3 * 0.3 + 0.2 * 0.2, 1e-9);
  SparseRow apart;
  state.add_offset(apart, state.lines()[0], 70);
  state.add_offset(apart, *line, 70, -1);
  EXPECT_LT(std::sqrt(state.numbers().variance(apart)), 0.21) << "it runs beside the other one";
  const std::uint64_t id = line->id;
  state.remove_line(0);
  EXPECT_EQ(state.find_line(id), &state.lines().back());
  EXPECT_NEAR(state.offset(state.lines().back(), 70), 1.8, 1e-12);
  EXPECT_EQ(state.find_line(99), nullptr);
}

TEST(RoadState, IsFullAtItsMostLines) {
  RoadState state{RoadConfig{}};
  for (std::size_t i = 0; i < RoadState::kMostLines; ++i) {
    ASSERT_NE(state.add_line(3.6 * static_cast<double>(i), 0.3), nullptr);
  }
  EXPECT_EQ(state.add_line(50, 0.3), nullptr);
  EXPECT_EQ(state.add_line_beside(state.lines()[0].id, 3.6, 0.3), nullptr);
  for (std::size_t i = 0; i < RoadState::kMostVehicles; ++i) {
    ASSERT_NE(state.add_vehicle(static_cast<std::int64_t>(i)), nullptr);
  }
  EXPECT_EQ(state.add_vehicle(77), nullptr);
  state.remove_vehicle(3);
  EXPECT_EQ(state.vehicles()[3].track_id, 4);
  state.remove_line(2);
  for (const RoadVehicle& vehicle : state.vehicles()) {
    EXPECT_GE(vehicle.index, state.lines().back().first + RoadState::kOffsets);
    EXPECT_LT(vehicle.index, state.numbers().size());
  }
}

TEST(RoadState, AFreedLineIsUncertainFromThereOn) {
  RoadState state = state_in_bend(0);
  const double near = state.variance(state.lines()[2], 0);
  const double far = state.variance(state.lines()[2], 120);
  const double other = state.variance(state.lines()[1], 120);
  state.free_line(state.lines()[2], 60, 0.5);
  EXPECT_EQ(state.variance(state.lines()[2], 0), near);
  EXPECT_NEAR(state.variance(state.lines()[2], 120), far + 0.25, 1e-6);
  EXPECT_EQ(state.variance(state.lines()[1], 120), other);
}

TEST(RoadState, LearnsHowMuchSensorsErrUnlessThatIsTakenAway) {
  RoadConfig config;
  RoadState learning{config};
  config.adapt_noise = false;
  RoadState believing{config};
  for (int i = 0; i < 1000; ++i) {
    learning.note_surprise(4 * config.usual_surprise);
    believing.note_surprise(4 * config.usual_surprise);
  }
  EXPECT_GT(learning.noise_scale(), 1.5);
  EXPECT_EQ(believing.noise_scale(), 1);
}

}  // namespace
}  // namespace lanefuse
