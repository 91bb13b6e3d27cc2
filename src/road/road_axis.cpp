// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/road_axis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {
namespace {

/// The hat function of width `l` about zero, integrated from minus infinity once and twice.
double once(double u, double l) {
  if (u <= -l) return 0;
  if (u <= 0) return (u + l) * (u + l) / (2 * l);
  if (u < l) return l - (l - u) * (l - u) / (2 * l);
  return l;
}

double twice(double u, double l) {
  if (u <= -l) return 0;
  if (u <= 0) return (u + l) * (u + l) * (u + l) / (6 * l);
  if (u < l) return l * u + (l - u) * (l - u) * (l - u) / (6 * l);
  return l * u;
}

}  // namespace

double hat_turn(double centre, double spacing, double station) {
  return once(station - centre, spacing) - once(-centre, spacing);
}

double hat_lever(double centre, double spacing, double station) {
  return twice(station - centre, spacing) - twice(-centre, spacing) - station * once(-centre, spacing);
}

KnotWeights knot_weights(double at, double begin, double spacing, int count) {
  const double place = std::clamp((at - begin) / spacing, 0.0, static_cast<double>(count - 1));
  const int first = std::min(static_cast<int>(place), count - 2);
  const double second = place - first;
  return {first, 1 - second, second};
}

double RoadAxis::knot_curvature(double station) const {
  const KnotWeights w = knot_weights(station, first_knot_, kKnotSpacing, kKnots);
  const auto i = static_cast<std::size_t>(w.first);
  return w.of_first * curvatures_[i] + w.of_second * curvatures_[i + 1];
}

void RoadAxis::rebuild(double heading, std::span<const double> curvatures, double first_knot) {
  assert(curvatures.size() == kKnots);
  std::copy(curvatures.begin(), curvatures.end(), curvatures_.begin());
  first_knot_ = first_knot;
  samples_[kOrigin] = {0, 0, -heading, knot_curvature(0)};
  const auto walk = [this](int from, int to) {
    const double step = (to - from) * kStep;
    const Sample& here = samples_[static_cast<std::size_t>(from)];
    Sample& next = samples_[static_cast<std::size_t>(to)];
    next.curvature = knot_curvature(kBegin + to * kStep);
    const double middle = here.heading + step / 8 * (3 * here.curvature + next.curvature);
    next.heading = here.heading + step / 2 * (here.curvature + next.curvature);
    next.x = here.x + step * std::cos(middle);
    next.y = here.y + step * std::sin(middle);
  };
  for (int i = kOrigin; i + 1 < kSteps; ++i) walk(i, i + 1);
  for (int i = kOrigin; i > 0; --i) walk(i, i - 1);
}

RoadAxis::Place RoadAxis::at(double station) const {
  const double place = std::clamp((station - kBegin) / kStep, 0.0, static_cast<double>(kSteps - 1));
  const auto i = static_cast<std::size_t>(std::lround(place));
  const Sample& near = samples_[i];
  const double step = station - (kBegin + static_cast<double>(i) * kStep);
  const double middle = near.heading + step / 2 * near.curvature;
  const double heading = near.heading + step * near.curvature;
  return {station,
          {near.x + step * std::cos(middle), near.y + step * std::sin(middle)},
          {std::cos(heading), std::sin(heading)}};
}

double RoadAxis::heading_at(double station) const {
  const KnotWeights w = knot_weights(station, kBegin, kStep, kSteps);
  const auto i = static_cast<std::size_t>(w.first);
  return w.of_first * samples_[i].heading + w.of_second * samples_[i + 1].heading;
}

double RoadAxis::curvature_at(double station) const { return knot_curvature(station); }

RoadAxis::Foot RoadAxis::project(const Eigen::Vector2d& point) const {
  // Along the road the axis advances in x all the time: the sample at the point's x is a good beginning.
  const auto* after = std::lower_bound(samples_.begin(), samples_.end(), point.x(),
                                       [](const Sample& sample, double x) { return sample.x < x; });
  const auto i = std::min<std::ptrdiff_t>(after - samples_.begin(), kSteps - 1);
  Place place = at(kBegin + static_cast<double>(i) * kStep);
  for (int iteration = 0; iteration < 3; ++iteration) {
    const Eigen::Vector2d away = point - place.point;
    const double squeeze = std::max(0.3, 1 - knot_curvature(place.station) * place.normal().dot(away));
    const double step = place.tangent.dot(away) / squeeze;
    place = at(std::clamp(place.station + step, kBegin, kEnd));
    if (std::abs(step) < 0.01) break;
  }
  return {place, place.normal().dot(point - place.point)};
}

}  // namespace lanefuse
