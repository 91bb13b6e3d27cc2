// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/road_surface.hpp"

namespace lanefuse {

/// The shade that lies on the road without moving: of trees beside it, in dapples, and of bridges over it.
class GroundShade {
 public:
  GroundShade(const Scene& scene, const SurfaceTextures& textures, const ImageLight& light,
              std::uint64_t seed);

  /// Takes the light from albedos of a run of pixels, as RoadSurface::shade gave them.
  void lay(const RoadPlace& from, const RoadPlace& to, const Footprint& footprint, int count,
           LinearColour* albedo) const;

 private:
  static constexpr double kStep = 2;  ///< [m]
  /// What lies on a piece of the road.
  struct Piece {
    float bridge = 0;  ///< share of the direct light that is taken
    float trees = 0;   ///< the same, where their leaves are
    int side = 0;      ///< on which they stand: +1 left
  };
  const SurfaceTextures* textures_;
  double station_;     ///< [m] of the ego car
  LinearColour kept_;  ///< of the light, in full shade
  std::vector<Piece> pieces_;

  void lay_trees(std::uint64_t seed);
  void lay_bridges(const Scene& scene, const ImageLight& light, std::uint64_t seed);
};

}  // namespace lanefuse
