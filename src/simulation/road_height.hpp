// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/random.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {

/// The road's ups and downs along its reference line: a vertical curvature that wanders with the way.
class RoadHeight {
 public:
  RoadHeight(const RoadPreset& preset, double length, Random& random);

  /// Height [m] of the road at `there` over the plane that touches it at `here`: what a camera that believes
  /// in a flat road does not know.
  [[nodiscard]] double above_tangent(double here, double there) const;

 private:
  struct Sample {
    double height;
    double slope;
  };
  std::vector<Sample> samples_;  ///< at every whole metre

  [[nodiscard]] Sample at(double station) const;
};

}  // namespace lanefuse
