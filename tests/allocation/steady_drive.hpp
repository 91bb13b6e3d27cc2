// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/feature.hpp"
#include "core/time.hpp"

namespace lanefuse::testing {

/// Calls of operator new so far, in the whole program.
std::size_t allocations();

/// What was allocated since it was made.
class Count {
 public:
  [[nodiscard]] std::size_t operator()() const { return allocations() - begin_; }

 private:
  std::size_t begin_ = allocations();
};

/// A cycle's feature sets, as cameras and the object source would make them.
inline std::vector<FeatureSet> sets_at(int cycle, Time now) {
  FeatureSet markings;
  markings.source = Source::high_resolution_camera;
  markings.sensor_id = 2;
  FeatureSet witnesses;
  witnesses.source = Source::objects;
  witnesses.sensor_id = 3;
  witnesses.lane_width = LaneWidth{3.5, 0.1};
  const Eigen::Matrix3d covariance = Eigen::Vector3d(0.5, 0.1, 0.01).cwiseAbs2().asDiagonal();
  const auto add = [&](FeatureSet& set, double x, double y) -> Feature& {
    Feature& feature = set.features.emplace_back();
    feature.x = x;
    feature.y = y;
    feature.confidence = 0.6;
    feature.covariance = covariance;
    return feature;
  };
  for (int i = 0; i < 20; ++i) {
    for (const double y : {-1.75, 1.75, 5.25}) add(markings, 3 * i + 3 - std::fmod(1.2 * cycle, 3), y);
  }
  for (const double y : {-1.75, 1.75}) {
    Feature& feature = add(witnesses, 40, y);
    feature.track_id = 7;
    feature.side = y > 0 ? Side::left : Side::right;
  }
  markings.measured_at = witnesses.measured_at = now;
  return {markings, witnesses};
}

}  // namespace lanefuse::testing
