// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/seen_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lanefuse {
namespace {

void show(const Feature& feature, const Pose2& now_from_measured, std::uint64_t line, DebugView& view) {
  FusedFeature& seen = view.features.emplace_back();
  seen.feature = feature;
  const Pose2 now = now_from_measured * Pose2{feature.x, feature.y, feature.heading};
  seen.feature.x = now.x;
  seen.feature.y = now.y;
  seen.feature.heading = now.heading;
  seen.feature.covariance = rotate_covariance(feature.covariance, now_from_measured.heading);
  seen.boundary = line;
  seen.in_base_fit = line != 0;
  seen.outlier = line == 0;
}

/// What the clothoid says at `x`, as a feature.
Feature feature_at(const ClothoidMeasurement& side, double x, Source source) {
  Feature feature;
  feature.x = x;
  feature.y = side.clothoid.y(x);
  feature.heading = side.clothoid.heading_at(x);
  feature.confidence = side.confidence;
  const Eigen::RowVector4d across = lateral_jacobian(x);
  // Along the line a place on it is known exactly; nobody reads the other two numbers.
  const double variance = std::max((across * side.covariance * across.transpose()).value(),
                                   std::numeric_limits<double>::epsilon());
  feature.covariance.diagonal() = Eigen::Vector3d(variance, variance, side.covariance(1, 1));
  feature.source = source;
  feature.side = side.side;
  feature.marking = side.marking;
  return feature;
}

}  // namespace

void show_paint(const FeatureSet& set, const Pose2& now_from_measured,
                std::span<const std::uint64_t> given_to, DebugView& view) {
  for (std::size_t i = 0; i < set.features.size(); ++i) {
    show(set.features[i], now_from_measured, given_to[i], view);
  }
}

void show_vehicles(const FeatureSet& set, const Pose2& now_from_measured,
                   std::span<const RoadVehicle> vehicles, DebugView& view) {
  for (const Feature& feature : set.features) {
    const auto vehicle = std::find_if(vehicles.begin(), vehicles.end(), [&](const RoadVehicle& known) {
      return known.track_id == feature.track_id;
    });
    const bool keeps_lane = vehicle != vehicles.end() && vehicle->in_lane && feature.side != Side::none;
    const std::uint64_t line = !keeps_lane ? 0 : feature.side == Side::left ? vehicle->left : vehicle->right;
    show(feature, now_from_measured, line, view);
  }
}

void show_tracked_lane(const FeatureSet& set, const Pose2& now_from_measured,
                       std::span<const std::uint64_t> given_to, DebugView& view) {
  constexpr int kPlaces = 4;
  for (std::size_t i = 0; i < set.clothoids.size(); ++i) {
    const ClothoidMeasurement& side = set.clothoids[i];
    for (int place = 0; place < kPlaces; ++place) {
      const double share = static_cast<double>(place) / (kPlaces - 1);
      const double x = side.range_begin + share * (side.range_end - side.range_begin);
      show(feature_at(side, x, set.source), now_from_measured, given_to[i], view);
    }
  }
}

}  // namespace lanefuse
