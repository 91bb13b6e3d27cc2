// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/ego_path_source.hpp"

#include <limits>
#include <numbers>

namespace lanefuse {
namespace {

/// No other track has this id.
constexpr std::int64_t kEgoTrack = std::numeric_limits<std::int64_t>::max();
constexpr double kSigmaAlong = 1;  ///< [m] irrelevant along the road, but a covariance needs one

}  // namespace

void EgoPathSource::collect(Time, const SourceContext& context, std::vector<FeatureSet>& sets) {
  if (!config_.enabled || context.motion.empty() || context.motion.back().speed < config_.min_speed) return;
  FeatureSet set;
  set.source = Source::ego_path;
  set.measured_at = context.motion.back().time;
  set.lane_width = context.lane_width.value_or(config_.default_width);
  const double heading = config_.driver_heading_deg * std::numbers::pi / 180;
  for (const Side side : {Side::left, Side::right}) {
    Feature feature;
    feature.y = (side == Side::left ? 0.5 : -0.5) * set.lane_width->mean;
    feature.confidence = config_.confidence;
    feature.covariance = Eigen::Vector3d(kSigmaAlong, config_.driver_sigma, heading).cwiseAbs2().asDiagonal();
    feature.track_id = kEgoTrack;
    feature.source = Source::ego_path;
    feature.side = side;
    set.features.push_back(feature);
  }
  sets.push_back(std::move(set));
}

}  // namespace lanefuse
