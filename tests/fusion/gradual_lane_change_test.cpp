// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/paper_scenes.hpp"

/// A lane change as drivers make it, seen in every cycle: five seconds, a degree or two of heading.
namespace lanefuse {
namespace {

using testing::FusionDrive;

constexpr double kCycleStep = 1.2;  ///< [m] at 30 m/s and 25 Hz
constexpr double kLength = 150;     ///< [m] of the lane change, 5 s
constexpr double kBegin = 40;       ///< [m] where the other car begins it

Pose2 vehicle_at(double x) {
  const double phase = std::numbers::pi * std::clamp((x - kBegin) / kLength, 0.0, 1.0);
  const double slope = -1.75 * std::sin(phase) * std::numbers::pi / kLength;
  return {x, 1.75 * (1 + std::cos(phase)), std::atan(slope)};
}

/// Follows the other car 30 m behind it; with cameras, in the right lane of two whose three markings they
/// see.
void follow(FusionDrive& drive, bool cameras) {
  for (double x = 0; x < kBegin + kLength; x += kCycleStep) {
    const Pose2 car{x, 0, 0};
    FeatureSet vehicle = drive.set(Source::objects, {}, 3);
    vehicle.lane_width = LaneWidth{3.5, 0.1};
    const Pose2 seen = car.inverse() * vehicle_at(x + 30);
    vehicle.features.push_back(testing::witnessed(7, Side::left, seen * Pose2{0, 1.75, 0}, 0.3));
    vehicle.features.push_back(testing::witnessed(7, Side::right, seen * Pose2{0, -1.75, 0}, 0.3));
    std::vector<FeatureSet> sets{vehicle};
    if (cameras) {
      for (const double y : {1.75, -1.75}) sets.insert(sets.begin(), testing::serial_set(drive, y, 4, 60));
    }
    drive.step(car, sets);
  }
}

std::vector<SwitchState> switches_after(bool cameras, double switch_prior) {
  FusionConfig config;
  config.switch_prior = switch_prior;
  config.drop_behind = 400;  // keeps the whole lane change
  FusionDrive drive(config);
  follow(drive, cameras);
  std::vector<SwitchState> states;
  drive.fusion().switch_states(states);
  return states;
}

double step_of(const SwitchState& state) { return std::abs(state.to.y() - state.from.y()); }

TEST(GradualLaneChange, IsATrailLikeAnyOtherWhereThereIsNoMarking) {
  const auto states = switches_after(false, FusionConfig{}.switch_prior);
  ASSERT_GT(states.size(), 200U);
  for (const SwitchState& state : states) {
    EXPECT_LT(step_of(state), 0.1);
    EXPECT_GT(state.value, 0.9);
  }
}

TEST(GradualLaneChange, SwitchesNothingByASmallerPriorEither) {
  for (const SwitchState& state : switches_after(false, 0.05)) EXPECT_GT(state.value, 0.5);
}

TEST(GradualLaneChange, SwitchesOffWhereItLetsGoOfAMarkingAndWhereItFindsTheNext) {
  const auto states = switches_after(true, FusionConfig{}.switch_prior);
  double first = 1e9;
  double last = -1e9;
  int off = 0;
  for (const SwitchState& state : states) {
    // J = (step / 0.1 m)^2 is above the prior of 4 from 0.2 m on; between, headings and curves play in.
    if (step_of(state) < 0.15) {
      EXPECT_GT(state.value, 0.5);
    }
    if (step_of(state) > 0.3) {
      EXPECT_LT(state.value, 0.5);
    }
    if (state.value >= 0.5) continue;
    ++off;
    first = std::min(first, state.from.x());
    last = std::max(last, state.to.x());
  }
  EXPECT_GE(off, 2);
  EXPECT_LE(off, 6);
  EXPECT_GT(last - first, 50) << "once at its beginning, once at its end";
}

}  // namespace
}  // namespace lanefuse
