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
  /// Everything on the road, in the vehicle frame of the moment of the image: see moved_to(). Its title is
  /// not used.
  std::optional<TopView> road;
};

struct OverlayConfig {
  int width = 1280;            ///< [px] of the picture, even
  int road_panel_height = 330; ///< [px] of the view from above
  double reach = 120;          ///< [m] ahead in the view from above
  double half_width = 16;      ///< [m] to each side in the view from above
};

/// The estimate as seen `seconds` later (or earlier, below zero): the road stands, the car has moved on with
/// the estimate's own speed and yaw rate.
LaneEstimate moved_by(const LaneEstimate& estimate, double seconds);
/// Fused features, switches and road course seen from a frame that has moved by `old_from_new`.
DebugView moved_by(const DebugView& debug, const Pose2& old_from_new);

/// Width and height of the picture are even and depend on the camera's image size alone.
Image draw_overlay(const OverlayScene& scene, const OverlayConfig& config = {});

}  // namespace lanefuse
