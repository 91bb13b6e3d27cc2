// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/lane_estimate.hpp"
#include "drawing/svg.hpp"
#include "sensors/measurement.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// One moment seen from above, as in the paper's figures [IROS16, figs. "Estimation of the base clothoid" and
/// "Exemplary result"]. All in the vehicle frame; whatever is empty is not drawn, and not in the legend
/// either.
struct TopView {
  std::string title;
  LaneEstimate estimate;
  DebugView debug;
  std::vector<std::vector<Eigen::Vector2d>> true_boundaries;
  std::vector<Eigen::Vector2d> driven_path;  ///< where the car went later
  std::vector<TrackedObject> vehicles;
};

/// The true boundaries as they lie in view of the car: for TopView::true_boundaries.
std::vector<std::vector<Eigen::Vector2d>> boundaries_in_view(const TrueRoad& road,
                                                             const Pose2& world_from_vehicle);

/// x forward to the right, y left upwards; the lateral axis is stretched to what is there to see.
Figure draw_top_view(const TopView& view);

}  // namespace lanefuse
