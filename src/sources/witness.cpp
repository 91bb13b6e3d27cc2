// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/witness.hpp"

#include <cmath>
#include <numbers>

#include "core/pose2.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kChanging = 0.3;  ///< of the confidence is left while a vehicle is between two lanes

}  // namespace

bool is_witness(const TrackedObject& object, const WitnessConfig& config) {
  const bool verified =
      object.seen_by_radar && (object.seen_by_camera || config.rule == WitnessRule::radar_only);
  const bool driving = object.movement != MovementState::stationary &&
                       object.movement != MovementState::stopped && object.speed > config.min_speed;
  const bool ahead = object.x > config.range_begin && object.x < config.range_max;
  return verified && driving && ahead &&
         std::abs(wrap_angle(object.heading)) < config.max_heading_deg * kDegree;
}

void add_witness_features(const TrackedObject& object, const LaneWidth& width, const WitnessConfig& config,
                          std::vector<Feature>& features) {
  const double c = std::cos(object.heading);
  const double s = std::sin(object.heading);
  const Eigen::Vector2d across(-s, c);
  const double heading_sigma = config.driver_heading_deg * kDegree;
  Eigen::Matrix3d covariance = object.covariance;
  covariance.topLeftCorner<2, 2>() += config.driver_sigma * config.driver_sigma * across * across.transpose();
  covariance(2, 2) += heading_sigma * heading_sigma;
  for (const Side side : {Side::left, Side::right}) {
    const double offset = side == Side::left ? width.mean / 2 : -width.mean / 2;
    Feature feature;
    feature.x = object.x + offset * across.x();
    feature.y = object.y + offset * across.y();
    feature.heading = object.heading;
    feature.confidence = config.confidence * object.existence * (object.changing_lane ? kChanging : 1);
    feature.changing_lane = object.changing_lane;
    feature.covariance = covariance;
    feature.source = Source::objects;
    feature.track_id = object.id;
    feature.side = side;
    feature.label = side == Side::left ? object.left_label : object.right_label;
    features.push_back(feature);
  }
}

}  // namespace lanefuse
