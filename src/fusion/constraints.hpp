// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/feature.hpp"
#include "core/pose2.hpp"
#include "fusion/fusion_config.hpp"

namespace lanefuse {

/// The information matrices Omega and targets z of every constraint of [IROS16, eqs. 4-9]. Each is expressed
/// in the measurement's own frame, x along the marking: that is where the residual of `Edge` lives.

/// Odometry over `distance` [m] in `seconds` [eq. 4].
Eigen::Matrix3d odometry_information(const OdometryNoise& noise, double distance, double seconds);

/// A measured feature [eqs. 5-7]. Its covariance is turned into its own heading; along it, sigma is never
/// believed to be smaller than `sigma_along`.
Eigen::Matrix3d measurement_information(const Feature& feature, double sigma_along);

/// Between a witness's right and left feature: w = [0, w, 0] [eq. 8]. Nothing is said along the road.
Pose2 width_target(const LaneWidth& width);
Eigen::Matrix3d width_information(const LaneWidth& width, const FusionConfig& config);

/// Between successive features on one side of a witness [eq. 9]. Nothing is said along the road.
Eigen::Matrix3d smoothing_information(const FusionConfig& config);

}  // namespace lanefuse
