// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "camera/camera_model.hpp"
#include "camera/image.hpp"
#include "sensors/camera_view.hpp"
#include "simulation/camera_chip.hpp"
#include "simulation/ground_rays.hpp"
#include "simulation/image_conditions.hpp"
#include "simulation/road_surface.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

/// What a rendered image looks like, beyond its geometry.
struct RenderConfig {
  ImageConditions conditions = ImageConditions::clear;
  double blur_px = 0.6;      ///< [px] sigma of the lens
  double vignetting = 0.28;  ///< of the light that is lost in a corner
  double wear = 1;           ///< of the paint: 0 as new, with straight edges; 1 as on an old motorway
  double texture = 1;        ///< contrast of the asphalt's grain, patches and seams; 0: one grey
  bool noise = true;         ///< of the chip
  int threads = 2;           ///< the bytes do not depend on it
  std::uint64_t seed = 1;    ///< of noise, texture and wear
};

/// Renders what a camera sees of a scene: the road with its true paint, the land around it, and vehicles that
/// hide what is behind them. Geometry is exact: a marking's centre lies where ImageTruth says. See
/// docs/rendered-images.md for what is modelled and what is not.
class CameraRenderer {
 public:
  CameraRenderer(const CameraIntrinsics& camera, const RenderConfig& config);

  [[nodiscard]] const CameraModel& camera() const { return camera_; }
  [[nodiscard]] const RenderConfig& config() const { return config_; }

  /// Blue, green, red. `mounting` is how the camera really stands over the road in this image; the road's
  /// heights are the scene's own. The same scene, mounting and configuration give the same bytes.
  [[nodiscard]] Image render(const Scene& scene, const Mounting& mounting) const;

 private:
  CameraModel camera_;
  SegmentEnds ends_;
  RenderConfig config_;
  ImageLight light_;
  std::shared_ptr<const SurfaceTextures> textures_;
  CameraChip chip_;
};

}  // namespace lanefuse
