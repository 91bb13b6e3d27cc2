// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/motion.hpp"

#include <algorithm>
#include <cassert>

namespace lanefuse {

bool pose_at(std::span<const MotionSample> samples, Time time, Duration reach, Pose2& odometry_from_vehicle) {
  assert(!samples.empty());
  const auto after = std::lower_bound(samples.begin(), samples.end(), time,
                                      [](const MotionSample& sample, Time t) { return sample.time < t; });
  if (after == samples.begin() || after == samples.end()) {
    const MotionSample& end = after == samples.end() ? samples.back() : samples.front();
    if (time - end.time > reach || end.time - time > reach) return false;
    odometry_from_vehicle =
        end.odometry_from_vehicle * constant_turn(end.speed, end.yaw_rate, to_seconds(time - end.time));
    return true;
  }
  const MotionSample& before = *(after - 1);
  const double fraction = to_seconds(time - before.time) / to_seconds(after->time - before.time);
  odometry_from_vehicle = interpolate(before.odometry_from_vehicle, after->odometry_from_vehicle, fraction);
  return true;
}

}  // namespace lanefuse
