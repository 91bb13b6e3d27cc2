// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/image_light.hpp"
#include "simulation/road_ahead.hpp"
#include "simulation/texture_tile.hpp"

namespace lanefuse {

/// What the ground is made of, for a whole drive: its textures.
struct SurfaceTextures {
  explicit SurfaceTextures(std::uint64_t seed);
  TextureTile grain;    ///< of asphalt and grass, by the centimetre
  TextureTile patches;  ///< by the metre
  TextureTile wear;     ///< of paint
};

/// How large a pixel is on the ground.
struct Footprint {
  double along = 0;   ///< [m]
  double across = 0;  ///< [m]
};

/// The bare ground ahead of one scene: asphalt with wheel tracks, patches and grain between the guard rails,
/// gravel and grass beyond. The same place has the same colour in every scene.
class RoadSurface {
 public:
  RoadSurface(const Scene& scene, const RoadAhead& road, const SurfaceTextures& textures, float asphalt,
              double contrast);

  /// Albedos of a run of `count` pixels from place `from` (the first) to `to` (one beyond the last).
  void shade(const RoadPlace& from, const RoadPlace& to, const Footprint& footprint, int count,
             LinearColour* albedo) const;

 private:
  static constexpr double kCell = 0.1;      ///< [m] across
  static constexpr double kStep = 2;        ///< [m] along
  static constexpr double kHalfWidth = 28;  ///< [m] to either side; what is beyond is as at the border
  static constexpr int kCells = static_cast<int>(2 * kHalfWidth / kCell) + 1;

  const SurfaceTextures* textures_;
  float contrast_;
  double station_;  ///< [m] of the ego car
  double first_;    ///< [m] station of the first cross-section
  int section_count_;
  std::vector<LinearColour> sections_;  ///< albedo, and the grain's contrast as the fourth number

  void lay_section(const Road& road, double station, float asphalt, LinearColour* cells) const;
};

}  // namespace lanefuse
