// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "camera/bar_chains.hpp"
#include "camera/road_rays.hpp"

namespace lanefuse {

/// What may be wrong with a bar in pixels: sideways its noise, and along the column where in its row the
/// paint lies that ends there.
struct PixelSigma {
  double across = 0;  ///< [px] of the column
  double along = 0;   ///< [px] of the row
};

/// Sigma of (x, y, heading) of paint at `ground`: the bar's own noise, and what the camera's pose and the
/// road's vertical curvature do to its place and to its direction together. `heading_sigma` [rad] is the
/// noise's part.
Eigen::Matrix3d marking_covariance(const RoadRays& rays, const RoadBar& bar, const PixelSigma& noise,
                                   double heading_sigma);

}  // namespace lanefuse
