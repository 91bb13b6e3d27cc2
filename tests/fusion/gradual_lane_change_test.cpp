// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
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

/// Follows the other car 30 m behind it; with cameras, in the right lane of two whose three markings they see.
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

TEST(GradualLaneChange, Probe) {
  for (const bool cameras : {false, true}) {
    for (const double prior : {4.0, 1.0, 0.5, 0.25, 0.1, 0.05}) {
      FusionConfig config;
      config.switch_prior = prior;
      config.drop_behind = 400;
      FusionDrive drive(config);
      follow(drive, cameras);
      std::vector<SwitchState> states;
      drive.fusion().switch_states(states);
      int off = 0, half = 0;
      for (const auto& s : states) {
        off += s.value < 0.5;
        half += s.value < 0.9;
        if (prior == 4.0 && s.value < 0.9)
          std::printf("   side %d from %.1f %.2f to %.1f %.2f : %.2f\n", int(s.side), s.from.x() + 190, s.from.y(), s.to.x() + 190, s.to.y(), s.value);
      }
      std::printf("cameras %d prior %.2f edges %zu off %d below .9 %d\n", cameras, prior, states.size(), off, half);
    }
  }
}

}  // namespace
}  // namespace lanefuse
