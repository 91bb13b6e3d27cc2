// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "camera/image.hpp"
#include "drawing/top_view.hpp"
#include "sensors/camera_intrinsics.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// One image with what was seen in it and the lanes that were estimated, as in the paper's figures of marking
/// features, of search windows and of fused boundaries [IROS16, figs. 2, 6, 7]. What is absent is not drawn.
struct OverlayScene {
  std::string title;  ///< of the drive
  std::string camera;
  double seconds = 0;  ///< since the first image
  ImageView image;     ///< blue, green, red; empty where it could not be decoded
  CameraIntrinsics intrinsics;
  std::optional<CameraView> view;  ///< nothing where the run did not look at this image
  CameraPose pose;                 ///< how the camera stood: the view's, else the rig's
  /// Everything on the road, in the vehicle frame of the moment of the image: see drawing/moved_view.hpp. Its
  /// title is not used.
  std::optional<TopView> road;
};

struct OverlayConfig {
  int width = 1280;        ///< [px] of the picture, even, 640 at least
  double reach = 120;      ///< [m] ahead in the view from above
  double half_width = 16;  ///< [m] to each side in the view from above
};

/// The picture is three panels: a line of words, the image, and below it the road from above, to scale. Its
/// width and height are even and depend on the camera's image size alone.
Image draw_overlay(const OverlayScene& scene, const OverlayConfig& config = {});

}  // namespace lanefuse
