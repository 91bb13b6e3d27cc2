// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "camera/camera_model.hpp"
#include "camera/reduced_image.hpp"
#include "camera/vehicle_detector.hpp"

namespace lanefuse {

/// A rectangle of a reduced image [px], edges at pixels' borders: left <= u < right.
struct PixelBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

/// The share of two boxes' union that both cover, in [0, 1].
double overlap(const PixelBox& a, const PixelBox& b);

/// Where a car that stands at some place of the road would be seen.
struct VehicleShape {
  double distance = 0;     ///< [m] along x to its rear
  double lateral = 0;      ///< [m] of the middle of its rear
  double width = 0;        ///< [m]
  PixelBox box;            ///< of what is seen of it: its rear and its side
  double rear_left = 0;    ///< [px] of the reduced image: its rear's columns
  double rear_right = 0;   ///< [px]
  bool left_cut = false;   ///< by the image's edge
  bool right_cut = false;  ///< by the image's edge
};

/// Cars at all places of the road where one is looked for, as the camera sees them; those that are cut so far
/// that nothing can be told are left out.
std::vector<VehicleShape> vehicle_shapes(const CameraModel& camera, const CameraPose& pose,
                                         const Reduction& reduction, const VehicleDetectorConfig& config);

}  // namespace lanefuse
