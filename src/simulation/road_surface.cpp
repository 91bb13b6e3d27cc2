// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_surface.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "simulation/ground_rays.hpp"

namespace lanefuse {
namespace {

constexpr double kVerge = 0.6;      ///< [m] of asphalt beyond a guard rail's line
constexpr double kGravel = 0.9;     ///< [m] beyond the asphalt
constexpr double kOtherSide = 4.5;  ///< [m] from the left guard rail to the other carriageway
constexpr double kOtherWidth = 11;  ///< [m] of it
constexpr float kGrassGrain = 0.28F;
constexpr float kAsphaltGrain = 0.13F;

LinearColour with_grain(LinearColour albedo, float grain) {
  albedo[3] = grain;
  return albedo;
}

float bell(double distance, double width) {
  const double q = distance / width;
  return static_cast<float>(std::exp(-q * q / 2));
}

/// How tyres and oil darken a lane, by the distance from its centre.
float used(double from_centre) {
  const float tracks = bell(std::abs(from_centre) - 0.85, 0.28);
  const float oil = bell(from_centre, 0.22);
  return 1 - 0.09F * tracks - 0.06F * oil;
}

}  // namespace

SurfaceTextures::SurfaceTextures(std::uint64_t seed)
    : grain({512, 512, 0.0125}, {{1, 0.7F}, {4, 0.6F}, {16, 0.35F}, {64, 0.2F}}, seed, "asphalt grain"),
      patches({256, 64, 0.5}, {{1, 0.4F}, {4, 0.6F}, {16, 0.8F}}, seed, "asphalt patches"),
      wear({512, 256, 0.02}, {{1, 0.4F}, {4, 0.7F}, {16, 0.8F}, {64, 0.6F}}, seed, "wear of paint") {}

RoadSurface::RoadSurface(const Scene& scene, const RoadAhead& road, const SurfaceTextures& textures,
                         float asphalt, double contrast)
    : textures_(&textures),
      contrast_(static_cast<float>(contrast)),
      station_(scene.ego.station),
      first_(std::floor((scene.ego.station + std::max(0.0, road.first())) / kStep) * kStep),
      section_count_(static_cast<int>(road.last() / kStep) + 2),
      sections_(static_cast<std::size_t>(section_count_) * kCells) {
  for (int i = 0; i < section_count_; ++i) {
    lay_section(*scene.road, first_ + i * kStep, asphalt, &sections_[static_cast<std::size_t>(i) * kCells]);
  }
}

void RoadSurface::lay_section(const Road& road, double station, float asphalt, LinearColour* cells) const {
  const double left = road.guard_rail(+1, station);
  const double right = road.guard_rail(-1, station);
  std::vector<double> centres;
  for (int lane = 0; lane < road.lane_count(); ++lane) {
    if (road.lane_exists(lane, station)) centres.push_back(road.lane_centre(lane, station));
  }
  const TextureTile::Level patches = textures_->patches.level(kStep, 0.5);
  const LinearColour grass = colour(0.05F, 0.15F, 0.11F);
  const LinearColour gravel = colour(0.16F, 0.19F, 0.21F);
  for (int i = 0; i < kCells; ++i) {
    const double lateral = -kHalfWidth + i * kCell;
    const float patch = contrast_ * patches.at(station, lateral);
    const double outside = std::max(lateral - left, right - lateral);
    const double on_other_side = lateral - left - kOtherSide;
    if (outside < kVerge || (on_other_side > 0 && on_other_side < kOtherWidth)) {
      float tone = asphalt * (1 + 0.07F * patch);
      for (const double centre : centres) {
        if (contrast_ > 0 && std::abs(lateral - centre) < 2) tone *= used(lateral - centre);
      }
      cells[i] = with_grain(colour(tone * 1.02F, tone, tone * 0.98F), kAsphaltGrain);
    } else if (outside < kVerge + kGravel) {
      cells[i] = with_grain(gravel * (1 + 0.1F * patch), kGrassGrain);
    } else {
      const LinearColour dry = colour(0, 0.02F, 0.035F);
      cells[i] = with_grain((grass + dry * patch).max(0.02F), kGrassGrain);
    }
  }
}

void RoadSurface::shade(const RoadPlace& from, const RoadPlace& to, const Footprint& footprint, int count,
                        LinearColour* albedo) const {
  const TextureTile::Level grain = textures_->grain.level(footprint.along, footprint.across);
  const double middle = station_ + (from.way + to.way) / 2;
  const double section = std::clamp((middle - first_) / kStep, 0.0, section_count_ - 1.001);
  const auto low = static_cast<int>(section);
  const auto between = static_cast<float>(section - low);
  const LinearColour* near = &sections_[static_cast<std::size_t>(low) * kCells];
  const LinearColour* far = near + kCells;
  const double lateral_step = (to.lateral - from.lateral) / count;
  std::array<float, GroundRays::kSegment> speckles;
  assert(count <= GroundRays::kSegment);
  grain.read_run({station_ + from.way, from.lateral, (to.way - from.way) / count, lateral_step}, count,
                 speckles.data());
  constexpr float kLast = kCells - 1.01F;
  const auto first_cell = static_cast<float>((from.lateral + kHalfWidth) / kCell);
  const auto cell_step = static_cast<float>(lateral_step / kCell);
  for (int i = 0; i < count; ++i) {
    const float cell = std::min(std::max(first_cell + static_cast<float>(i) * cell_step, 0.0F), kLast);
    const auto index = static_cast<int>(cell);
    const float across = cell - static_cast<float>(index);
    const LinearColour here = near[index] + across * (near[index + 1] - near[index]);
    const LinearColour there = far[index] + across * (far[index + 1] - far[index]);
    const LinearColour ground = here + between * (there - here);
    albedo[i] = ground * (1 + contrast_ * ground[3] * speckles[i]);
  }
}

}  // namespace lanefuse
