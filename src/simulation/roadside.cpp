// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/roadside.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/random.hpp"
#include "simulation/image_air.hpp"

namespace lanefuse {
namespace {

constexpr double kRailEnd = 300;    ///< [m] ahead, where a rail is thinner than a pixel
constexpr double kPostEnd = 90;     ///< [m]
constexpr double kPostEvery = 4;    ///< [m]
constexpr double kTreeEnd = 350;    ///< [m]
constexpr double kTreeEvery = 9;    ///< [m]
constexpr double kTreeGroup = 120;  ///< [m] of the road with trees or without

/// Places over the road, in the vehicle frame.
class Heights {
 public:
  Heights(const Scene& scene, const RoadAhead& road) : scene_(&scene), road_(&road) {}
  [[nodiscard]] Eigen::Vector3d rail(int side, double way, double height) const {
    return place({way, scene_->road->guard_rail(side, scene_->ego.station + way)}, height);
  }
  [[nodiscard]] Eigen::Vector3d place(const RoadPlace& place, double height) const {
    const Eigen::Vector2d at = road_->point(place);
    return {at.x(), at.y(), road_->height(place.way) + height};
  }

 private:
  const Scene* scene_;
  const RoadAhead* road_;
};

void add_beam(const Heights& heights, int side, double from, double to, ImageFaces& faces) {
  const auto band = [&](double low, double high, float albedo) {
    const Eigen::Vector3d middle = heights.rail(side, (from + to) / 2, 0);
    const LinearColour seen = albedo * light_upright(middle.x(), middle.y(), faces.light());
    faces.add({heights.rail(side, from, low), heights.rail(side, to, low), heights.rail(side, to, high),
               heights.rail(side, from, high)},
              middle.head<2>().norm(), {seen, 1});
  };
  const double third = (kRailTop - kRailBottom) / 3;
  band(kRailBottom, kRailBottom + third, 0.30F);
  band(kRailBottom + third, kRailTop - third, 0.20F);
  band(kRailTop - third, kRailTop, 0.42F);
}

void add_post(const Heights& heights, int side, double way, ImageFaces& faces) {
  const Eigen::Vector3d foot = heights.rail(side, way, 0);
  const LinearColour seen = 0.16F * light_upright(foot.x(), foot.y(), faces.light());
  const auto corner = [&](double along, double height) { return heights.rail(side, way + along, height); };
  // Just behind its beam.
  faces.add({corner(-0.06, 0), corner(0.06, 0), corner(0.06, kRailBottom), corner(-0.06, kRailBottom)},
            foot.head<2>().norm() + 1.5, {seen, 1});
}

/// A ball of leaves as a ragged polygon that faces the camera.
void add_leaves(const Eigen::Vector3d& middle, double radius, const LinearColour& colour, Random& random,
                ImageFaces& faces) {
  const Eigen::Vector2d ahead = middle.head<2>().normalized();
  std::vector<Eigen::Vector3d> outline;
  constexpr int kCorners = 12;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / kCorners;
    const double aside = radius * std::cos(angle);
    outline.push_back(middle +
                      Eigen::Vector3d(-ahead.y() * aside, ahead.x() * aside, radius * std::sin(angle)));
  }
  faces.add(outline, middle.head<2>().norm(), {colour, 1});
}

void add_tree(const Eigen::Vector3d& foot, Random& random, ImageFaces& faces) {
  const double height = random.uniform(5, 12);
  const LinearColour light = light_upright(foot.x(), foot.y(), faces.light());
  const double distance = foot.head<2>().norm();
  const Eigen::Vector3d up(0, 0, 1);
  const Eigen::Vector3d aside(0, 0.18, 0);
  faces.add({foot - aside, foot + aside, foot + aside + 0.5 * height * up, foot - aside + 0.5 * height * up},
            distance + 1, {colour(0.04F, 0.05F, 0.07F) * light, 1});
  const LinearColour leaves =
      colour(0.035F, 0.085F, 0.06F) * (1 + 0.35F * static_cast<float>(random.uniform(-1, 1)));
  // Small balls near by, where they are seen one by one; the lit ones above and before the dark ones.
  const int balls = distance < 120 ? 42 : 12;
  const double size = distance < 120 ? 0.075 : 0.13;
  for (int i = 0; i < balls; ++i) {
    const double up_share = (i + 0.5) / balls;
    const double crown = std::sin(std::numbers::pi * std::min(1.0, 0.18 + 0.82 * up_share));
    const double around = random.uniform(0, 2 * std::numbers::pi);
    const double off = 0.27 * height * crown * std::sqrt(random.uniform());
    const Eigen::Vector3d middle = foot + Eigen::Vector3d(off * std::cos(around), off * std::sin(around),
                                                          height * (0.28 + 0.66 * up_share));
    const auto shade = static_cast<float>(0.5 + 0.65 * up_share + random.uniform(-0.25, 0.25));
    add_leaves(middle, size * height * random.uniform(0.7, 1.3), leaves * light * shade, random, faces);
  }
}

}  // namespace

void add_guard_rails(const Scene& scene, const RoadAhead& road, ImageFaces& faces) {
  const Heights heights(scene, road);
  for (const int side : {+1, -1}) {
    // Pieces begin and end at places of the road, so that they do not swim.
    const double phase = std::fmod(scene.ego.station, kPostEvery);
    for (double way = -phase; way < kRailEnd;) {
      const double length = way < 60 ? kPostEvery : 3 * kPostEvery;
      add_beam(heights, side, way, way + length, faces);
      if (way < kPostEnd) add_post(heights, side, way, faces);
      way += length;
    }
  }
}

void add_trees(const Scene& scene, const RoadAhead& road, std::uint64_t seed, ImageFaces& faces) {
  const Heights heights(scene, road);
  const double here = scene.ego.station;
  for (double station = std::ceil(here / kTreeEvery) * kTreeEvery; station < here + kTreeEnd;
       station += kTreeEvery) {
    for (const int side : {+1, -1}) {
      const auto group = static_cast<int>(station / kTreeGroup);
      if (!Random(seed, fmt::format("trees {} {}", side, group)).chance(0.5)) continue;
      Random random(seed, fmt::format("tree {} {}", side, static_cast<int>(station)));
      const double beyond = side > 0 ? random.uniform(19, 34) : random.uniform(4.5, 22);
      const double along = station - here + random.uniform(-4, 4);
      const double lateral = scene.road->guard_rail(side, station) + side * beyond;
      add_tree(heights.place({along, lateral}, 0), random, faces);
    }
  }
}

}  // namespace lanefuse
