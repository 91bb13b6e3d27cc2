// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/feature.hpp"
#include "core/pose2.hpp"
#include "road/road_config.hpp"
#include "road/road_state.hpp"

namespace lanefuse {

/// Where a point of paint is, once what is wrong with its camera's frame is taken out, and how that changes
/// with it. A camera places paint where its ray meets the ground: pitch and crests move the point along the
/// ray, which fans lines out or in; yaw and lean turn it.
struct SeenPaint {
  Eigen::Vector2d point;      ///< vehicle frame of now
  Eigen::Vector2d by_pitch;   ///< change of the point with kPaintPitch
  Eigen::Vector2d by_height;  ///< with the road's relative height there
  Eigen::Vector2d by_turn;    ///< with kPaintYaw or kPaintLean
};
SeenPaint corrected(const Eigen::Vector2d& seen, const Pose2& now_from_measured, const RoadState& state);

/// The variance of the feature's place across `normal` (of the vehicle frame in which it was measured) that
/// is its own: what the whole frame shares is counted in the state.
double own_variance(const Feature& feature, const Eigen::Vector2d& normal, const CameraErrorsConfig& config);

}  // namespace lanefuse
