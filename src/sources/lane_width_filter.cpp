// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/lane_width_filter.hpp"

#include <cmath>

namespace lanefuse {
namespace {

constexpr double kNarrowest = 2.0;    ///< [m] no lane is narrower
constexpr double kWidest = 6.0;       ///< [m] nor wider
constexpr double kGain = 0.05;        ///< share of a new measurement
constexpr double kSigmaFloor = 0.05;  ///< [m]

}  // namespace

void LaneWidthFilter::update(const FeatureSet& set) {
  const ClothoidMeasurement* left = nullptr;
  const ClothoidMeasurement* right = nullptr;
  for (const ClothoidMeasurement& clothoid : set.clothoids) {
    if (clothoid.side == Side::left) left = &clothoid;
    if (clothoid.side == Side::right) right = &clothoid;
  }
  if (!left || !right) return;
  const double across = std::cos(left->clothoid.heading_at(0));
  const double measured = (left->clothoid.lateral_offset - right->clothoid.lateral_offset) * across;
  if (!(measured > kNarrowest && measured < kWidest)) return;
  const double sigma = std::sqrt(left->covariance(0, 0) + right->covariance(0, 0)) + kSigmaFloor;
  if (!width_) {
    width_ = LaneWidth{measured, sigma};
  } else {
    width_->mean += kGain * (measured - width_->mean);
    width_->standard_deviation += kGain * (sigma - width_->standard_deviation);
  }
  last_seen_ = set.measured_at;
}

std::optional<LaneWidth> LaneWidthFilter::width(Time now, Duration max_age) const {
  return width_ && now - last_seen_ <= max_age ? width_ : std::nullopt;
}

}  // namespace lanefuse
