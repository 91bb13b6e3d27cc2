// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_height.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {

RoadHeight::RoadHeight(const RoadPreset& preset, double length, Random& random) {
  Wander curvature(preset.vertical_curvature_sigma, preset.vertical_curvature_length, random);
  samples_.reserve(static_cast<std::size_t>(length) + 2);
  samples_.push_back({0, 0});
  for (double station = 0; station < length; ++station) {
    const auto [height, slope] = samples_.back();
    samples_.push_back({height + slope + curvature.value() / 2, slope + curvature.value()});
    curvature.advance(1, random);
  }
}

RoadHeight::Sample RoadHeight::at(double station) const {
  const double last = static_cast<double>(samples_.size() - 2);
  const double metre = std::clamp(std::floor(station), 0.0, last);
  const Sample& low = samples_[static_cast<std::size_t>(metre)];
  const double curvature = samples_[static_cast<std::size_t>(metre) + 1].slope - low.slope;
  const double way = station - metre;
  return {low.height + way * (low.slope + way * curvature / 2), low.slope + way * curvature};
}

double RoadHeight::above_tangent(double here, double there) const {
  const Sample at_here = at(here);
  return at(there).height - at_here.height - at_here.slope * (there - here);
}

}  // namespace lanefuse
