// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace lanefuse {

/// A camera's lens and chip: a pinhole with Brown-Conrady distortion, in OpenCV's conventions. Pixels are
/// counted from the middle of the upper left one; u to the right, v down.
struct CameraIntrinsics {
  int width = 0;                       ///< [px] of an image
  int height = 0;                      ///< [px] of an image
  double fx = 0;                       ///< [px] focal length
  double fy = 0;                       ///< [px]
  double cx = 0;                       ///< [px] principal point
  double cy = 0;                       ///< [px]
  std::array<double, 5> distortion{};  ///< k1, k2, p1, p2, k3
  friend bool operator==(const CameraIntrinsics&, const CameraIntrinsics&) = default;
};

}  // namespace lanefuse
