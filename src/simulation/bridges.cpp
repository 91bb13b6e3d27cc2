// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/bridges.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/random.hpp"
#include "simulation/image_air.hpp"

namespace lanefuse {
namespace {

constexpr double kBlock = 900;    ///< [m] of the road, with one bridge or none
constexpr double kChance = 0.55;  ///< of one
constexpr double kDeck = 1.3;     ///< [m] that the deck is high
constexpr double kSight = 350;    ///< [m]
constexpr double kBank = 25;      ///< [m] beyond the rails, where the deck meets the land

class BridgePainter {
 public:
  BridgePainter(const Scene& scene, const RoadAhead& road, ImageFaces& faces)
      : scene_(&scene), road_(&road), faces_(&faces) {}

  void paint(const Stretch& bridge) {
    const double near = bridge.begin - scene_->ego.station;
    const double far = bridge.end - scene_->ego.station;
    const double left = scene_->road->guard_rail(+1, bridge.begin);
    const double right = scene_->road->guard_rail(-1, bridge.begin);
    const double top = kBridgeClearance + kDeck;
    wall({far, near}, left + 2, {0, kBridgeClearance}, 0.20F);
    wall({far, near}, right - 2, {0, kBridgeClearance}, 0.20F);
    add({at(near, left + kBank, kBridgeClearance), at(far, left + kBank, kBridgeClearance),
         at(far, right - kBank, kBridgeClearance), at(near, right - kBank, kBridgeClearance)},
        (near + far) / 2, 0.06F);
    front(near, {left + kBank, left + 2}, {0, kBridgeClearance}, 0.26F);
    front(near, {right - 2, right - kBank}, {0, kBridgeClearance}, 0.26F);
    front(near, {left + kBank, right - kBank}, {kBridgeClearance, top}, 0.34F);
    front(near, {left + kBank, right - kBank}, {top, top + 0.12}, 0.22F);
  }

 private:
  const Scene* scene_;
  const RoadAhead* road_;
  ImageFaces* faces_;

  [[nodiscard]] Eigen::Vector3d at(double way, double lateral, double height) const {
    const Eigen::Vector2d point = road_->point({way, lateral});
    return {point.x(), point.y(), road_->height(way) + height};
  }
  void add(const std::vector<Eigen::Vector3d>& corners, double way, float albedo) {
    const double distance = std::max(0.5, way);
    faces_->add(corners, distance, {albedo * light_upright(distance, 0, faces_->light()), 1});
  }
  void front(double way, const Eigen::Vector2d& lateral, const Eigen::Vector2d& height, float albedo) {
    add({at(way, lateral[0], height[0]), at(way, lateral[1], height[0]), at(way, lateral[1], height[1]),
         at(way, lateral[0], height[1])},
        way, albedo);
  }
  void wall(const Eigen::Vector2d& way, double lateral, const Eigen::Vector2d& height, float albedo) {
    add({at(way[0], lateral, height[0]), at(way[1], lateral, height[0]), at(way[1], lateral, height[1]),
         at(way[0], lateral, height[1])},
        way.mean(), 0.4F * albedo);
  }
};

}  // namespace

std::vector<Stretch> bridges_over(const Stretch& road, std::uint64_t seed) {
  std::vector<Stretch> bridges;
  constexpr double kLongest = 18;  // [m]
  for (double block = std::floor((road.begin - kLongest) / kBlock); block * kBlock < road.end; ++block) {
    Random random(seed, fmt::format("bridge {}", static_cast<int>(block)));
    const bool there = random.chance(kChance);
    const double begin = block * kBlock + random.uniform(100, kBlock - 100);
    const Stretch bridge{begin, begin + random.uniform(9, kLongest)};
    if (there && bridge.begin < road.end && bridge.end > road.begin) bridges.push_back(bridge);
  }
  return bridges;
}

void add_bridges(const Scene& scene, const RoadAhead& road, std::uint64_t seed, ImageFaces& faces) {
  BridgePainter painter(scene, road, faces);
  const double here = scene.ego.station;
  for (const Stretch& bridge : bridges_over({here - 1, here + kSight}, seed)) painter.paint(bridge);
}

}  // namespace lanefuse
