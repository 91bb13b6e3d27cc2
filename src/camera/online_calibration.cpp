// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/online_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lanefuse {
namespace {

constexpr double kBlock = 0.5;             ///< [s]
constexpr double kShortestBlock = 8;       ///< [m]
constexpr double kStrongAcceleration = 1;  ///< [m/s^2] pitches the car on its springs

double square(double value) { return value * value; }

/// The variance of the mean over `seconds` of something that wanders with time constant `tau`.
double mean_variance(double sigma, double tau, double seconds) {
  return square(sigma) * std::min(1.0, 2 * tau / seconds);
}

}  // namespace

OnlineCalibration::OnlineCalibration(const Mounting& mounting, const OnlineCalibrationConfig& config)
    : config_(config), mounting_(mounting) {
  reset();
}

void OnlineCalibration::reset() {
  state_.mean << mounting_.z, mounting_.roll, mounting_.pitch, mounting_.yaw, 0, 0;
  state_.covariance.setZero();
  state_.covariance.diagonal() << square(config_.height_sigma), square(config_.roll_sigma),
      square(config_.pitch_sigma), square(config_.yaw_sigma), square(config_.lane_difference_sigma),
      square(config_.lane_difference_sigma);
  status_ = CalibrationStatus::learning;
  block_ = {};
  last_.reset();
  residuals_.fill({});
  learned_ = 0;
  publish();
}

void OnlineCalibration::publish() {
  pose_.mounting = mounting_;
  pose_.mounting.z = state_.mean[kHeight];
  pose_.mounting.roll = state_.mean[kRoll];
  pose_.mounting.pitch = state_.mean[kPitch];
  pose_.mounting.yaw = state_.mean[kYaw];
  pose_.covariance = state_.covariance.topLeftCorner<4, 4>();
}

void OnlineCalibration::update(const LaneTrack& track, double speed, double yaw_rate, Time time) {
  const double seconds = last_ ? to_seconds(time - *last_) : 0;
  last_ = time;
  if (track.lane_changed) forget_differences();
  constexpr double kPause = 0.3;  // [s]
  const bool usable = track.status == LaneTrackStatus::tracking && track.left && track.right &&
                      !track.lane_changed && speed >= config_.slowest && seconds < kPause;
  if (!usable) {
    block_ = {};
    return;
  }
  add(track, speed, yaw_rate, seconds);
  if (block_.seconds < kBlock || block_.way < kShortestBlock) return;
  finish_block();
  block_ = {};
}

void OnlineCalibration::add(const LaneTrack& track, double speed, double yaw_rate, double seconds) {
  if (block_.images == 0) {
    block_.first_speed = speed;
  } else {
    block_.seconds += seconds;
    block_.way += speed * seconds;
  }
  block_.last_speed = speed;
  block_.images += 1;
  block_.way_sum += block_.way;
  block_.way_squares += square(block_.way);
  block_.offset_sum += track.lateral_offset;
  block_.offset_way_sum += track.lateral_offset * block_.way;
  block_.heading_sum += track.heading - pose_.mounting.yaw;
  block_.pitch_sum += track.pitch + pose_.mounting.pitch;
  block_.width_sum += track.width / pose_.mounting.z;
  block_.curvature_sum += yaw_rate / speed;
  add_neighbour(track, Side::left);
  add_neighbour(track, Side::right);
}

/// A camera that is rolled by e more than assumed shows a marking at y at y - e (h + y^2 / h): lanes on its
/// left narrower and on its right wider.
void OnlineCalibration::add_neighbour(const LaneTrack& track, Side side) {
  const auto& neighbour = side == Side::left ? track.left_neighbour : track.right_neighbour;
  constexpr double kLikely = 0.8;  // [m]
  if (!neighbour || std::abs(neighbour->width - track.width) > kLikely) return;
  constexpr double kPaint = 0.15;  // [m]
  const double outward = side == Side::left ? 1 : -1;
  const double near_edge = outward * track.lateral_offset + track.width / 2 + kPaint;
  const double far_edge = near_edge + neighbour->width;
  const double height = pose_.mounting.z;
  const double neighbour_lever = -outward * (square(far_edge) - square(near_edge)) / height;
  const double ego_lever = -2 * track.width * track.lateral_offset / height;
  Block::Neighbour& sums = block_.neighbours[side == Side::left ? 0 : 1];
  sums.images += 1;
  // It learns by the lever of lanes of the usual width around a car in their middle: the measured one errs
  // together with the measured difference, and the filter would follow that.
  constexpr double kUsual = 3.6;  // [m]
  constexpr double kEdge = kUsual / 2 + kPaint;
  sums.lever_sum += -outward * (square(kEdge + kUsual) - square(kEdge)) / mounting_.z;
  // What a roll of nothing would show, to be independent of the pose assumed.
  sums.difference_sum += neighbour->width - track.width + (neighbour_lever - ego_lever) * pose_.mounting.roll;
  sums.variance_sum += square(neighbour->sigma) + square(track.width_sigma);
}

void OnlineCalibration::finish_block() {
  // Loads, screws and temperatures change slowly.
  constexpr double kHeightWalk = 1e-4;      // [m] in 1 s
  constexpr double kAngleWalk = 1e-4;       // [rad] in 1 s
  constexpr double kDifferenceWalk = 2e-3;  // [m] in 1 s
  state_.covariance(kHeight, kHeight) += square(kHeightWalk) * block_.seconds;
  for (const int angle : {kRoll, kPitch, kYaw}) {
    state_.covariance(angle, angle) += square(kAngleWalk) * block_.seconds;
  }
  for (const int difference : {kLeftDifference, kRightDifference}) {
    double& variance = state_.covariance(difference, difference);
    variance = std::min(variance + square(kDifferenceWalk) * block_.seconds,
                        std::max(variance, square(config_.lane_difference_sigma)));
  }
  learned_ += block_.seconds;
  learn_pitch();
  learn_yaw();
  learn_roll(Side::left);
  learn_roll(Side::right);
  learn_height();
  constexpr double kKnown = 0.0017;     // [rad] of pitch and yaw: 0.1 deg
  constexpr double kRollKnown = 0.008;  // [rad]
  constexpr double kAtLeast = 4;        // [s]
  const auto variance = state_.covariance.diagonal();
  if (learned_ >= kAtLeast && variance[kPitch] < square(kKnown) && variance[kYaw] < square(kKnown) &&
      variance[kRoll] < square(kRollKnown)) {
    status_ = CalibrationStatus::steady;
  }
  publish();
}

void OnlineCalibration::learn_pitch() {
  if (std::abs(block_.last_speed - block_.first_speed) > kStrongAcceleration * block_.seconds) return;
  const double pitch = block_.pitch_sum / block_.images;
  learn(kPitch, pitch - state_.mean[kPitch], RowVector::Unit(kPitch),
        mean_variance(config_.body_pitch_sigma, config_.body_pitch_tau, block_.seconds));
}

/// dy/ds is the lane's true heading; what the camera reports is less by its yaw.
void OnlineCalibration::learn_yaw() {
  const double n = block_.images;
  const double spread = block_.way_squares - square(block_.way_sum) / n;
  if (!(spread > 0)) return;
  const double slope = (block_.offset_way_sum - block_.offset_sum * block_.way_sum / n) / spread;
  const double yaw = slope - block_.heading_sum / n;
  // Errors of the tracked offset live for about three images.
  constexpr double kOffsetSigma = 0.02;  // [m]
  constexpr double kLife = 3;
  const double slip = config_.slip_lever * block_.curvature_sum / n;
  learn(kYaw, yaw - state_.mean[kYaw], RowVector::Unit(kYaw),
        kLife * square(kOffsetSigma) / spread + square(config_.slip_sigma) + square(slip));
}

void OnlineCalibration::learn_roll(Side side) {
  const Block::Neighbour& sums = block_.neighbours[side == Side::left ? 0 : 1];
  constexpr double kLeast = 2;  // images
  if (sums.images < kLeast) return;
  const double lever = sums.lever_sum / sums.images;
  RowVector jacobian = RowVector::Zero();
  jacobian[kRoll] = lever;
  const int difference = side == Side::left ? kLeftDifference : kRightDifference;
  jacobian[difference] = 1;
  const double variance =
      sums.variance_sum / square(sums.images) +
      square(lever) * mean_variance(config_.body_roll_sigma, config_.body_roll_tau, block_.seconds);
  learn(difference, sums.difference_sum / sums.images - jacobian * state_.mean, jacobian, variance);
}

void OnlineCalibration::learn_height() {
  if (!config_.lane_width) return;
  const double apparent = block_.width_sum / block_.images;  // lane widths a camera height
  const double variance = square(config_.lane_width_sigma / apparent);
  // The road's error does not shrink by looking at it again.
  if (state_.covariance(kHeight, kHeight) < variance) return;
  constexpr double kSlowly = 10;
  learn(kHeight, *config_.lane_width / apparent - state_.mean[kHeight], RowVector::Unit(kHeight),
        kSlowly * variance);
}

void OnlineCalibration::learn(int what, double residual, const RowVector& jacobian, double variance) {
  const double known = jacobian * state_.covariance * jacobian.transpose();
  Residuals& last = residuals_[static_cast<std::size_t>(what)];
  std::rotate(last.values.begin(), last.values.end() - 1, last.values.end());
  last.values[0] = residual;
  last.count = std::min(last.count + 1, kRemembered);
  // Neighbouring blocks are not quite independent.
  constexpr double kDependent = 1.3;
  constexpr double kContradiction = 3.5;  // [sigma] of one block
  const auto contradicts = [&](std::size_t blocks, double sigmas) {
    const auto n = static_cast<double>(blocks);
    const auto end = last.values.begin() + static_cast<std::ptrdiff_t>(blocks);
    const double mean = std::accumulate(last.values.begin(), end, 0.0) / n;
    return last.count >= blocks && std::abs(mean) > sigmas * std::sqrt(known + kDependent * variance / n);
  };
  if (contradicts(3, 4.8) || contradicts(kRemembered, 4.8)) {
    knock(what);
  } else if (std::abs(residual) > kContradiction * std::sqrt(known + variance)) {
    return;
  }
  const Eigen::Matrix<double, 1, 1> surprise(residual);
  const Eigen::Matrix<double, 1, 1> noise(variance);
  lanefuse::update<kSize, 1>(state_, surprise, jacobian, noise);
}

void OnlineCalibration::knock(int what) {
  if (what == kHeight) return;
  constexpr double kKnocked = 0.025;      // [rad]
  constexpr double kRollPerhaps = 0.004;  // [rad] rolled where only pitch or yaw told
  state_.covariance(kPitch, kPitch) += square(kKnocked);
  state_.covariance(kYaw, kYaw) += square(kKnocked);
  const bool rolled = what == kLeftDifference || what == kRightDifference;
  state_.covariance(kRoll, kRoll) += square(rolled ? kKnocked : kRollPerhaps);
  status_ = CalibrationStatus::bumped;
  learned_ = 0;
  residuals_.fill({});
}

void OnlineCalibration::forget_differences() {
  for (const int difference : {kLeftDifference, kRightDifference}) {
    state_.mean[difference] = 0;
    state_.covariance.row(difference).setZero();
    state_.covariance.col(difference).setZero();
    state_.covariance(difference, difference) = square(config_.lane_difference_sigma);
  }
}

}  // namespace lanefuse
