// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/yaw_rate_bias.hpp"

#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

void YawRateBias::reset() {
  const Eigen::Vector2d sigma(config_.start_sigma_deg * kDegree, config_.wheel_mismatch_sigma);
  state_.mean.setZero();
  state_.covariance = sigma.cwiseAbs2().asDiagonal();
  gyro_sum_ = 0;
  gyro_count_ = 0;
  stands_ = false;
  last_.reset();
}

void YawRateBias::add(const VehicleMotion& motion) {
  const Time time = motion.stamp.measured_at;
  if (last_ && time > *last_) {
    const double drift = config_.drift_deg * kDegree;
    state_.covariance(0, 0) += drift * drift * to_seconds(time - *last_);
  }
  last_ = time;
  if (motion.speed) stands_ = std::abs(*motion.speed) < config_.standstill_speed;
  if (motion.yaw_rate) {
    gyro_sum_ += *motion.yaw_rate;
    ++gyro_count_;
    if (stands_) compare_with_standstill(*motion.yaw_rate);
  }
  if (motion.wheel_speeds && gyro_count_ > 0) compare_with_wheels(*motion.wheel_speeds);
}

void YawRateBias::compare_with_wheels(const std::array<double, 4>& wheel_speeds) {
  const double gyro = gyro_sum_ / gyro_count_;
  gyro_sum_ = 0;
  gyro_count_ = 0;
  const double left = wheel_speeds[2];
  const double right = wheel_speeds[3];
  const double from_wheels = (right - left) / config_.track_width;
  // gyro - wheels = bias - mismatch * v / track
  const Eigen::RowVector2d jacobian(1, -(left + right) / 2 / config_.track_width);
  const Eigen::Matrix<double, 1, 1> residual(gyro - from_wheels - jacobian * state_.mean);
  const double noise = config_.wheel_noise_deg * kDegree;
  update<2, 1>(state_, residual, jacobian, Eigen::Matrix<double, 1, 1>(noise * noise));
}

void YawRateBias::compare_with_standstill(double yaw_rate) {
  constexpr double kGyroNoise = 0.3 * kDegree;
  const Eigen::RowVector2d jacobian(1, 0);
  const Eigen::Matrix<double, 1, 1> residual(yaw_rate - state_.mean[0]);
  update<2, 1>(state_, residual, jacobian, Eigen::Matrix<double, 1, 1>(kGyroNoise * kGyroNoise));
}

}  // namespace lanefuse
