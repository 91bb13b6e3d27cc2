// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/impossible_inputs.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

constexpr double kFarthest = 1000;        ///< [m] no sensor of a car reaches so far
constexpr double kLeastVariance = 1e-12;  ///< nothing is known better
constexpr double kMostVariance = 1e6;     ///< nor does anything say less
constexpr double kReach = 62;             ///< [m] to which a tracked lane is looked at
constexpr double kNarrowest = 1;          ///< [m] lane
constexpr double kWidest = 10;

bool is_possible(const Feature& feature) {
  const auto variances = feature.covariance.diagonal();
  return std::abs(feature.x) < kFarthest && std::abs(feature.y) < kFarthest &&
         std::isfinite(feature.heading) && feature.confidence >= 0 && feature.confidence <= 1 &&
         feature.covariance.allFinite() && variances.minCoeff() >= kLeastVariance &&
         variances.maxCoeff() <= kMostVariance && feature.covariance.llt().info() == Eigen::Success;
}

/// A clothoid's covariance may be singular: a camera may not measure all of its four numbers.
bool is_possible(const ClothoidMeasurement& measurement) {
  const auto variances = measurement.covariance.diagonal();
  const Clothoid& clothoid = measurement.clothoid;
  return clothoid.vector().allFinite() && std::abs(clothoid.lateral_offset) < kFarthest &&
         std::abs(clothoid.y(kReach)) < kFarthest && std::abs(clothoid.slope(kReach)) < kFarthest &&
         measurement.covariance.allFinite() && variances.minCoeff() >= 0 &&
         variances.maxCoeff() <= kMostVariance && std::isfinite(measurement.range_begin) &&
         std::isfinite(measurement.range_end);
}

bool is_possible(const std::optional<LaneWidth>& width) {
  return !width || (width->mean >= kNarrowest && width->mean <= kWidest && width->standard_deviation > 0 &&
                    width->standard_deviation <= kWidest);
}

template <typename Item>
std::uint64_t keep_possible(const std::vector<Item>& all, std::vector<Item>& possible) {
  possible.clear();
  for (const Item& item : all) {
    if (is_possible(item)) possible.push_back(item);
  }
  return all.size() - possible.size();
}

}  // namespace

const FeatureSet& ImpossibleInputs::sort_out(const FeatureSet& set) {
  count_ = 0;
  const auto possible = [](const auto& item) { return is_possible(item); };
  if (std::all_of(set.features.begin(), set.features.end(), possible) &&
      std::all_of(set.clothoids.begin(), set.clothoids.end(), possible) && is_possible(set.lane_width)) {
    return set;
  }
  count_ = keep_possible(set.features, sound_.features) + keep_possible(set.clothoids, sound_.clothoids);
  sound_.source = set.source;
  sound_.sensor_id = set.sensor_id;
  sound_.measured_at = set.measured_at;
  sound_.status = set.status;
  sound_.lane_width = is_possible(set.lane_width) ? set.lane_width : std::nullopt;
  sound_.shared_error = set.shared_error;
  return sound_;
}

}  // namespace lanefuse
