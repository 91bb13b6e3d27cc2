// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/feature.hpp"
#include "core/time.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// Why an image cannot be believed.
enum class ImageFault : std::uint8_t {
  none = 0,
  empty = 1,        ///< no bytes, or no camera of the rig
  corrupt = 2,      ///< no image that can be decoded
  wrong_size = 3,   ///< not the size that the camera's calibration is for
  too_dark = 4,     ///< black, or too dark to show anything
  overexposed = 5,  ///< white
  incomplete = 6,   ///< half-transmitted: a part of it is one colour
  frozen = 7,       ///< the same picture as before though the car moves
};
const char* to_string(ImageFault fault);

enum class CalibrationStatus : std::uint8_t {
  learning = 0,  ///< starts from the rig's mounting; its uncertainty is still large
  steady = 1,
  bumped = 2,  ///< the camera has moved; what it sees is not believed until it has been learned anew
};
const char* to_string(CalibrationStatus status);

/// How a camera stands over the road in one image: the rig's mounting as corrected online, the pitch of this
/// very image in it, and how the road ahead bends.
struct CameraPose {
  Mounting mounting;
  double vertical_curvature = 0;  ///< [1/m] of the road ahead, positive where it rises
  /// of (height [m], roll, pitch, yaw [rad])
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double vertical_curvature_sigma = 0;  ///< [1/m]
};

/// A vehicle in the image. Columns and rows in pixels of the raw (distorted) image.
struct VehicleBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;      ///< where its wheels stand
  double distance = 0;    ///< [m] along x to where its rear touches the road
  double lateral = 0;     ///< [m] of the middle of its rear, positive to the left
  double width = 0;       ///< [m]
  double confidence = 0;  ///< in [0, 1]
};

/// A piece of one image row in which a lane tracker looked for a marking's edge.
struct SearchWindow {
  double row = 0;    ///< [px]
  double left = 0;   ///< [px] column
  double right = 0;  ///< [px] column
  Side side = Side::none;
  bool found = false;
  double column = 0;  ///< [px] of the edge, where it was found
};

/// A bright bar in one image row that may be paint.
struct ImageBar {
  double row = 0;         ///< [px]
  double left = 0;        ///< [px] column of its left edge
  double right = 0;       ///< [px] column of its right edge
  bool believed = false;  ///< became a marking feature
};

/// What was seen in one image, in pixels: for pictures, for those who debug, and for judging the camera.
struct CameraView {
  std::uint32_t sensor_id = 0;
  Time measured_at{};
  ImageFault fault = ImageFault::none;
  CalibrationStatus calibration = CalibrationStatus::learning;
  CameraPose pose;
  std::vector<VehicleBox> vehicles;
  std::vector<SearchWindow> windows;
  std::vector<ImageBar> bars;
};

}  // namespace lanefuse
