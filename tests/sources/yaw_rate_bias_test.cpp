// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/yaw_rate_bias.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A car whose gyro is off by `bias` and whose rear right wheel is smaller, so that it claims to be faster.
struct Car {
  double bias = 0;
  double mismatch = 0;
  bool has_wheel_speeds = true;

  [[nodiscard]] VehicleMotion at(double seconds, double speed, double yaw_rate) const {
    const double half_track = YawRateBiasConfig{}.track_width / 2;
    const Time time{from_seconds(1 + seconds)};
    VehicleMotion motion{{time, time, 0}, speed, yaw_rate + bias, {}};
    if (has_wheel_speeds) {
      const double left = speed - yaw_rate * half_track;
      const double right = (speed + yaw_rate * half_track) * (1 + mismatch);
      motion.wheel_speeds = {left, right, left, right};
    }
    return motion;
  }
};

/// Two minutes through bends, at a speed that swings between 20 and 40 m/s or stays at 30.
double bias_found(const Car& car, bool speed_changes) {
  YawRateBias bias({});
  for (int i = 0; i < 12'000; ++i) {
    const double seconds = 0.01 * i;
    const double speed = 30 + (speed_changes ? 10 * std::sin(seconds / 8) : 0);
    bias.add(car.at(seconds, speed, 0.03 * std::sin(seconds / 5)));
  }
  return bias.value();
}

TEST(YawRateBias, IsFoundFromTheWheels) {
  for (const double planted : {0.5 * kDegree, -0.3 * kDegree}) {
    EXPECT_NEAR(bias_found({planted}, true), planted, 0.03 * kDegree);
  }
}

TEST(YawRateBias, IsToldFromUnequalWheelsWhileTheSpeedChanges) {
  const double planted = 0.4 * kDegree;
  EXPECT_NEAR(bias_found({planted, 0.003}, true), planted, 0.06 * kDegree);
  EXPECT_NEAR(bias_found({0, 0.003}, true), 0, 0.06 * kDegree) << "unequal wheels alone are no bias";
}

TEST(YawRateBias, IsFoundAtStandstillWithoutWheelSpeeds) {
  const Car car{0.7 * kDegree, 0, false};
  YawRateBias bias({});
  for (int i = 0; i < 500; ++i) bias.add(car.at(0.01 * i, 0, 0));
  EXPECT_NEAR(bias.value(), car.bias, 0.02 * kDegree);
}

TEST(YawRateBias, TakesNoTurnForABiasWhileBackingUp) {
  const Car car{0, 0, false};
  YawRateBias bias({});
  for (int i = 0; i < 500; ++i) bias.add(car.at(0.01 * i, -3, 0.2));
  EXPECT_EQ(bias.value(), 0);
}

TEST(YawRateBias, StaysZeroWhereNothingTells) {
  const Car car{0.5 * kDegree, 0, false};
  EXPECT_EQ(bias_found(car, true), 0);
}

TEST(YawRateBias, ForgetsOnReset) {
  const Car car{0.7 * kDegree, 0, false};
  YawRateBias bias({});
  for (int i = 0; i < 100; ++i) bias.add(car.at(0.01 * i, 0, 0));
  ASSERT_NE(bias.value(), 0);
  bias.reset();
  EXPECT_EQ(bias.value(), 0);
  for (int i = 0; i < 100; ++i) bias.add(car.at(0.01 * i, 30, 0));
  EXPECT_EQ(bias.value(), 0) << "nor does it still believe that the car stands";
}

}  // namespace
}  // namespace lanefuse
