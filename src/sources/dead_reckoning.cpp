// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/dead_reckoning.hpp"

#include <algorithm>

namespace lanefuse {

InputAccounting DeadReckoning::add(const VehicleMotion& motion) {
  const Time time = motion.stamp.measured_at;
  if (!samples_.empty() && time < samples_.back().time) return {0, 0, 1};
  bias_.add(motion);
  if (motion.speed) speed_ = motion.speed;
  if (motion.yaw_rate) yaw_rate_ = *motion.yaw_rate - bias_.value();
  if (speed_ && yaw_rate_) extend(time, *speed_, *yaw_rate_);
  return {1, 0, 0};
}

void DeadReckoning::extend(Time time, double speed, double yaw_rate) {
  MotionSample next{time, {}, speed, yaw_rate};
  if (!samples_.empty()) {
    const MotionSample& last = samples_.back();
    const double seconds = to_seconds(time - last.time);
    if (seconds > config_.gap_s) {
      samples_.clear();
      ++restarts_;
    } else {
      // The trapezoid: between two messages the motion changes evenly.
      const Pose2 step =
          constant_turn((last.speed + next.speed) / 2, (last.yaw_rate + next.yaw_rate) / 2, seconds);
      next.odometry_from_vehicle = last.odometry_from_vehicle * step;
      if (seconds == 0) samples_.pop_back();
    }
  }
  samples_.push_back(next);
  const Time oldest = time - from_seconds(config_.history_s);
  const auto keep =
      std::find_if(samples_.begin(), samples_.end(), [&](const auto& s) { return s.time >= oldest; });
  // Trimmed in one go now and then, so that a sample is not moved at every message.
  if (keep - samples_.begin() > 512) samples_.erase(samples_.begin(), keep);
}

void DeadReckoning::reset() {
  bias_.reset();
  samples_.clear();
  speed_.reset();
  yaw_rate_.reset();
  restarts_ = 0;
}

}  // namespace lanefuse
