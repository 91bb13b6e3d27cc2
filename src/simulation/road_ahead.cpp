// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {

RoadAhead::RoadAhead(const Scene& scene, double behind, double ahead) : first_(-std::ceil(behind)) {
  const Road& road = *scene.road;
  const Pose2 ego_from_world = scene.ego.world_from_vehicle.inverse();
  const auto count = static_cast<std::size_t>(std::ceil(behind) + std::ceil(ahead)) + 1;
  samples_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double station = scene.ego.station + first_ + static_cast<double>(i);
    const double on_road = std::clamp(station, 0.0, road.length());
    const Pose2 pose = ego_from_world * (road.pose(on_road, 0) * Pose2{station - on_road, 0, 0});
    samples_.push_back({pose.x, pose.y, std::cos(pose.heading), std::sin(pose.heading),
                        station == on_road ? road.reference().curvature(station) : 0,
                        road.height().above_tangent(scene.ego.station, station)});
  }
}

RoadAhead::Local RoadAhead::at(double way) const {
  const double index = way - first_;
  const double whole = std::clamp(std::floor(index), 0.0, static_cast<double>(samples_.size() - 2));
  return {&samples_[static_cast<std::size_t>(whole)], index - whole};
}

RoadPlace RoadAhead::place(double x, double y, double guess) const {
  RoadPlace place{guess, 0};
  constexpr int kIterations = 4;
  for (int i = 0; i < kIterations; ++i) {
    const auto [low, t] = at(place.way);
    const Sample& high = low[1];
    // The chord, bent by the curvature: an arc to second order.
    const double bend = -t * (1 - t) / 2 * low->curvature;
    const double cos = low->cos + t * (high.cos - low->cos);
    const double sin = low->sin + t * (high.sin - low->sin);
    const double dx = x - (low->x + t * (high.x - low->x) - bend * sin);
    const double dy = y - (low->y + t * (high.y - low->y) + bend * cos);
    place.lateral = dy * cos - dx * sin;
    const double step = (dx * cos + dy * sin) / std::max(0.2, 1 - low->curvature * place.lateral);
    place.way += step;
    if (std::abs(step) < 1e-3) break;
  }
  return place;
}

Eigen::Vector2d RoadAhead::point(const RoadPlace& place) const {
  const auto [low, t] = at(place.way);
  const Sample& high = low[1];
  const double bend = -t * (1 - t) / 2 * low->curvature;
  const double cos = low->cos + t * (high.cos - low->cos);
  const double sin = low->sin + t * (high.sin - low->sin);
  return {low->x + t * (high.x - low->x) - (bend + place.lateral) * sin,
          low->y + t * (high.y - low->y) + (bend + place.lateral) * cos};
}

double RoadAhead::height(double way) const {
  const auto [low, t] = at(way);
  return low->height + t * (low[1].height - low->height);
}

}  // namespace lanefuse
