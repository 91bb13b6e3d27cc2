// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/radar_clutter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanefuse {
namespace {

constexpr double kStanding = 0.7;   ///< share of the clutter
constexpr double kAgain = 0.8;      ///< probability that it is a thing seen before
constexpr double kOverhead = 0.15;  ///< share of the standing things that are anywhere over the road
constexpr double kVerge = 2.5;      ///< [m] beyond the guard rail in which things stand
constexpr int kTries = 8;           ///< to find a place at the roadside in a narrow field
constexpr double kNearest = 2;      ///< [m]
constexpr double kFastest = 40;     ///< [m/s] range rate of what is not there, either way

}  // namespace

Eigen::Vector2d RadarClutter::anywhere(const RadarView& view) {
  const double range = random_.uniform(std::min(kNearest, view.range() / 2), view.range());
  const double half = view.half_field(range);
  const double bearing = random_.uniform(-half, half);
  return view.world_from_radar() * Eigen::Vector2d(range * std::cos(bearing), range * std::sin(bearing));
}

/// At the roadside, or over the road; where the field shows no roadside, just there.
Eigen::Vector2d RadarClutter::new_thing(const Scene& scene, const RadarView& view) {
  Eigen::Vector2d place = anywhere(view);
  if (random_.chance(kOverhead)) return place;
  const Pose2& world_from_ego = scene.ego.world_from_vehicle;
  for (int i = 0; i < kTries; ++i, place = anywhere(view)) {
    const Eigen::Vector2d seen = world_from_ego.inverse() * place;
    const int side = seen.y() > 0 ? 1 : -1;
    const auto rail =
        rails_->beside(scene, {scene.ego.station + seen.x(), world_from_ego * Pose2{seen.x(), 0, 0}}, side);
    if (!rail) continue;
    Eigen::Vector2d thing = rail->world_from_rail * Eigen::Vector2d(0, side * random_.uniform(0, kVerge));
    if (view.sees(thing)) return thing;
  }
  return place;
}

/// Those looked at in this scan stand first in the list.
Eigen::Vector2d RadarClutter::standing(const Scene& scene, const RadarView& view, std::size_t& looked_at) {
  std::size_t chosen = things_.size();
  if (looked_at < things_.size() && random_.chance(kAgain)) {
    chosen = looked_at +
             static_cast<std::size_t>(random_.uniform() * static_cast<double>(things_.size() - looked_at));
  } else {
    things_.push_back(new_thing(scene, view));
  }
  std::swap(things_[chosen], things_[looked_at]);
  return things_[looked_at++];
}

std::vector<RadarDetection> RadarClutter::observe(const Scene& scene, const RadarView& view) {
  std::erase_if(things_, [&view](const Eigen::Vector2d& thing) { return !view.sees(thing); });
  std::vector<RadarDetection> detections;
  std::size_t looked_at = 0;
  for (int left = random_.poisson(mean_); left > 0; --left) {
    if (random_.chance(kStanding)) {
      detections.push_back(view.measure({standing(scene, view, looked_at)}));
    } else {
      detections.push_back(view.measure({anywhere(view)}));
      detections.back().range_rate = random_.uniform(-kFastest, kFastest);
    }
  }
  return detections;
}

}  // namespace lanefuse
