// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "benchmark/error_figure.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/measurement.hpp"
#include "simulation/image_truth.hpp"

namespace lanefuse {

/// A tracked lane, the camera's pose and the vehicles in rendered images against what was there.
struct LaneTrackFigures {
  static constexpr int kDistances = 10;         ///< 0, 10 ... 90 m
  Share tracked;                                ///< of the images: both markings
  double range_sum = 0;                         ///< [m] of the nearer end of both, over the images tracked
  std::array<ErrorFigure, kDistances> lateral;  ///< [m] of inner edges within their range
  ErrorFigure pitch;                            ///< [rad] of the image, with its own sigma
  ErrorFigure yaw;                              ///< [rad] of the mounting, with its own sigma
  ErrorFigure roll;                             ///< [rad] the same
  Share vehicles_found;                         ///< of those nearer than 50 m that show at least their half
  Share boxes_true;                             ///< of the boxes nearer than 50 m

  [[nodiscard]] double mean_range() const {
    return tracked.count == 0 ? 0 : range_sum / static_cast<double>(tracked.count);
  }
  LaneTrackFigures& operator+=(const LaneTrackFigures& other);
};

void judge_lane(const Scene& scene, const ImageTruth& truth, const std::optional<SerialLane>& lane,
                LaneTrackFigures& figures);
void judge_pose(const ImageTruth& truth, const CameraView& view, LaneTrackFigures& figures);
void judge_vehicles(const std::vector<VehicleBox>& true_boxes, const std::vector<VehicleBox>& seen,
                    LaneTrackFigures& figures);

/// Intersection over union.
double overlap(const VehicleBox& a, const VehicleBox& b);

}  // namespace lanefuse
