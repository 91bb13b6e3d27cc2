// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/ground_rays.hpp"
#include "simulation/image_light.hpp"
#include "simulation/texture_tile.hpp"

namespace lanefuse {

/// What lies beyond the ground's end: fields up to the horizon, woods and hills on it, and the sky. Fixed to
/// the world's directions, so that it turns as the car turns.
class ImageBackdrop {
 public:
  /// `heading` [rad] of the car in the world.
  ImageBackdrop(const GroundRays& rays, const CameraIntrinsics& camera, const ImageLight& light,
                const TextureTile& texture, double heading);

  /// Colours of all pixels of row `v`.
  void draw_row(int v, LinearColour* pixels) const;

 private:
  struct Column {
    float horizon = 0;  ///< [px] row
    float woods = 0;    ///< [px] row of their top
    float hills = 0;    ///< [px] row of their top
    float glow = 0;     ///< the sun's, in this column
  };
  ImageLight light_;
  const TextureTile* texture_;
  double pixels_a_radian_;
  double sun_height_;   ///< [px] over the horizon
  double bearing_ = 0;  ///< [px] of the first column in the world
  std::vector<Column> columns_;
  std::vector<LinearColour> sky_;  ///< by the pixel over the horizon

  void lay_sky(int height);
  [[nodiscard]] float glow_of_row(float above_horizon) const;
};

}  // namespace lanefuse
