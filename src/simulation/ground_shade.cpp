// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/ground_shade.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/random.hpp"
#include "simulation/bridges.hpp"
#include "simulation/ground_rays.hpp"

namespace lanefuse {
namespace {

constexpr double kGrove = 90;  ///< [m] of the road, with trees that shade it or without
constexpr double kGroveChance = 0.3;
constexpr double kAlong = 0.10;    ///< by which the dapples' noise is stretched along the road
constexpr double kAcross = 0.035;  ///< and across it: shadows of a side light lie across

LinearColour kept_in_shade(const ImageLight& light) {
  if (light.headlights) return grey(1);
  if (light.sun.head<3>().maxCoeff() <= 0) return grey(0.62F);
  return light.ambient / (light.ambient + light.sun).max(1e-3F);
}

}  // namespace

GroundShade::GroundShade(const Scene& scene, const SurfaceTextures& textures, const ImageLight& light,
                         std::uint64_t seed)
    : textures_(&textures),
      station_(scene.ego.station),
      kept_(kept_in_shade(light)),
      pieces_(static_cast<std::size_t>(GroundRays::kGroundEnd / kStep) + 2) {
  if (light.headlights) return;
  if (light.sun.head<3>().maxCoeff() > 0) lay_trees(seed);
  lay_bridges(scene, light, seed);
}

void GroundShade::lay_trees(std::uint64_t seed) {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double station = station_ + static_cast<double>(i) * kStep;
    const double grove = std::floor(station / kGrove);
    Random random(seed, fmt::format("grove {}", static_cast<int>(grove)));
    if (!random.chance(kGroveChance)) continue;
    pieces_[i].side = random.chance(0.5) ? +1 : -1;
    // Thick in the middle of the grove, nothing at its ends.
    const double along = station / kGrove - grove;
    pieces_[i].trees = static_cast<float>(std::sin(std::numbers::pi * along));
  }
}

void GroundShade::lay_bridges(const Scene& scene, const ImageLight& light, std::uint64_t seed) {
  const double azimuth = light.sun_azimuth - scene.ego.world_from_vehicle.heading;
  const bool sunny = light.sun.head<3>().maxCoeff() > 0;
  // A low sun shines under a bridge: its shadow lies far away.
  const double moved = sunny ? -std::cos(azimuth) * kBridgeClearance / std::tan(light.sun_height) : 0;
  const Stretch road{station_ - moved, station_ - moved + GroundRays::kGroundEnd};
  for (const Stretch& bridge : bridges_over(road, seed)) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const double station = station_ + static_cast<double>(i) * kStep - moved;
      const double inside = std::min(station - bridge.begin, bridge.end - station);
      const auto share = static_cast<float>(std::clamp(inside / kStep + 0.5, 0.0, 1.0));
      pieces_[i].bridge = std::max(pieces_[i].bridge, share);
    }
  }
}

void GroundShade::lay(const RoadPlace& from, const RoadPlace& to, const Footprint& footprint, int count,
                      LinearColour* albedo) const {
  const double middle = (from.way + to.way) / 2;
  const double at = std::clamp(middle / kStep, 0.0, static_cast<double>(pieces_.size()) - 1.001);
  const Piece& low = pieces_[static_cast<std::size_t>(at)];
  const Piece& high = pieces_[static_cast<std::size_t>(at) + 1];
  const auto between = static_cast<float>(at - std::floor(at));
  const float bridge = low.bridge + between * (high.bridge - low.bridge);
  const float trees = low.trees + between * (high.trees - low.trees);
  if (bridge <= 0 && trees <= 0) return;
  const double lateral_step = (to.lateral - from.lateral) / count;
  std::array<float, GroundRays::kSegment> leaves;
  assert(count <= GroundRays::kSegment);
  const TextureTile::Level noise =
      textures_->wear.level(footprint.along * kAlong, footprint.across * kAcross);
  noise.read_run({(station_ + from.way) * kAlong, from.lateral * kAcross,
                  (to.way - from.way) / count * kAlong, lateral_step * kAcross},
                 count, leaves.data());
  const float side = static_cast<float>(low.side != 0 ? low.side : high.side);
  for (int i = 0; i < count; ++i) {
    const auto towards = side * static_cast<float>((from.lateral + i * lateral_step) / 8);
    const float leaf = std::clamp(3 * (leaves[static_cast<std::size_t>(i)] + towards - 0.3F), 0.0F, 1.0F);
    const float shade = std::max(bridge, trees * leaf);
    albedo[i] *= 1 - shade * (1 - kept_);
  }
}

}  // namespace lanefuse
