// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/car_following.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {
constexpr double kFullBraking = -8;  ///< [m/s^2]
constexpr double kStandstill = 0.2;  ///< [m/s] a slower wish is one to stand
}  // namespace

double CarFollowing::free(double speed) const {
  if (wished_speed < kStandstill) return speed > 0 ? -comfortable_braking : 0;
  return std::max(-comfortable_braking, acceleration * (1 - std::pow(speed / wished_speed, 4)));
}

double CarFollowing::behind(double speed, double gap, double leader_speed) const {
  const double closing = speed * (speed - leader_speed) / (2 * std::sqrt(acceleration * comfortable_braking));
  const double wished_gap = standstill_gap + std::max(0.0, speed * headway + closing);
  const double ratio = wished_gap / std::max(gap, 0.1);
  return std::max(kFullBraking, free(speed) - acceleration * ratio * ratio);
}

}  // namespace lanefuse
