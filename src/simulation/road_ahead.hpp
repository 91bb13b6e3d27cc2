// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "simulation/scene.hpp"

namespace lanefuse {

/// A place on the road, counted from the ego car: `way` [m] is the station less the ego car's.
struct RoadPlace {
  double way = 0;      ///< [m]
  double lateral = 0;  ///< [m]
};

/// The road around the ego car in tables, fast enough to ask for every pixel: reference line and height by
/// the metre, in the vehicle frame of the scene. Beyond the road's ends it goes on straight.
class RoadAhead {
 public:
  /// Covers from `behind` [m] behind the ego car to `ahead` [m] ahead.
  RoadAhead(const Scene& scene, double behind, double ahead);

  [[nodiscard]] double first() const { return first_; }  ///< [m] way at which the tables begin
  [[nodiscard]] double last() const { return first_ + static_cast<double>(samples_.size() - 1); }

  /// The place under a point of the vehicle frame; `guess` is a way near it.
  [[nodiscard]] RoadPlace place(double x, double y, double guess) const;
  [[nodiscard]] Eigen::Vector2d point(const RoadPlace& place) const;
  /// [m] over the plane that touches the road under the ego car.
  [[nodiscard]] double height(double way) const;

 private:
  struct Sample {
    double x, y, cos, sin, curvature, height;
  };
  double first_;
  std::vector<Sample> samples_;

  struct Local {
    const Sample* low;
    double fraction;
  };
  [[nodiscard]] Local at(double way) const;
};

}  // namespace lanefuse
