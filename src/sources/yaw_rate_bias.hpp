// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "core/kalman.hpp"
#include "core/time.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

struct YawRateBiasConfig {
  double start_sigma_deg = 0.6;         ///< [deg/s] of a gyro's bias before anything is known
  double drift_deg = 0.01;              ///< [deg/s / sqrt(s)] random walk of the bias
  double wheel_mismatch_sigma = 0.003;  ///< relative difference of the rear wheels' radii
  double wheel_noise_deg = 3;           ///< [deg/s] of the rear wheels' yaw rate in one message
  double track_width = 1.57;            ///< [m] between the rear wheels
  double standstill_speed = 0.05;       ///< [m/s] below, the car stands and the gyro shows its bias alone
};

/// What the gyro's yaw rate is off by, from the difference of the rear wheels' speeds, and from standing
/// still.
///
/// Two unknowns: the bias, and the mismatch of the wheels' radii, whose false yaw rate grows with the speed.
/// A Kalman filter over both tells them apart as soon as the speed changes. Without wheel speeds the bias is
/// taken to be zero until the car stands.
class YawRateBias {
 public:
  explicit YawRateBias(const YawRateBiasConfig& config) : config_(config) { reset(); }

  void add(const VehicleMotion& motion);
  [[nodiscard]] double value() const { return state_.mean[0]; }  ///< [rad/s]
  void reset();

 private:
  void compare_with_wheels(const std::array<double, 4>& wheel_speeds);
  void compare_with_standstill(double yaw_rate);

  YawRateBiasConfig config_;
  Gaussian<2> state_;  ///< bias [rad/s], relative mismatch of the wheels
  double gyro_sum_ = 0;
  int gyro_count_ = 0;
  bool stands_ = false;
  std::optional<Time> last_;
};

}  // namespace lanefuse
