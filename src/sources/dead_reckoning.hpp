// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/lane_estimate.hpp"
#include "core/motion.hpp"
#include "sensors/measurement.hpp"
#include "sources/yaw_rate_bias.hpp"

namespace lanefuse {

struct DeadReckoningConfig {
  double history_s = 3;  ///< [s] of motion kept, for measurements that arrive late
  double gap_s = 0.5;    ///< [s] without motion after which the old path is worth nothing: it starts anew
  YawRateBiasConfig bias;
};

/// Integrates what the car's buses say of its motion, u = [yaw rate, speed] of [IROS16, sec. II-E1], to a
/// path.
class DeadReckoning {
 public:
  explicit DeadReckoning(const DeadReckoningConfig& config) : config_(config), bias_(config.bias) {}

  /// Messages in order of measured_at; one that is older than the path's end is dropped.
  InputAccounting add(const VehicleMotion& motion);

  /// The path of the last seconds, from old to new. Empty until speed and yaw rate both have been heard.
  [[nodiscard]] std::span<const MotionSample> samples() const { return samples_; }

  /// How often the path had to start anew: poses before and after have nothing to do with each other.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }

  [[nodiscard]] double yaw_rate_bias() const { return bias_.value(); }

  void reset();

 private:
  void extend(Time time, double speed, double yaw_rate);

  DeadReckoningConfig config_;
  YawRateBias bias_;
  std::vector<MotionSample> samples_;
  std::optional<double> speed_;
  std::optional<double> yaw_rate_;
  std::uint32_t restarts_ = 0;
};

}  // namespace lanefuse
