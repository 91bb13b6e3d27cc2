// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "camera/ground_projection.hpp"
#include "camera/lane_segmentation.hpp"
#include "core/feature.hpp"

namespace lanefuse {

/// Marking features of what a network found: each run's middle on the road, its heading from the runs above
/// and below it, its covariance from the pixels and from the camera's pose. Runs that became features are
/// marked as believed.
std::vector<Feature> features_of_runs(std::vector<ImageBar>& runs, const GroundProjection& projection,
                                      const LaneSegmentationConfig& config);

}  // namespace lanefuse
