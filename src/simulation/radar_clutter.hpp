// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "simulation/guard_rails.hpp"
#include "simulation/radar_view.hpp"

namespace lanefuse {

/// What a radar sees that is no vehicle: mostly things that stand beside or over the road (posts of the guard
/// rail, signs, bridges), each seen again and again while it is in the field; else nothing at all, anywhere
/// and with any range rate.
class RadarClutter {
 public:
  /// `mean` detections a scan.
  RadarClutter(double mean, std::shared_ptr<const GuardRails> rails, Random random)
      : mean_(mean), rails_(std::move(rails)), random_(random) {}

  /// Without errors.
  std::vector<RadarDetection> observe(const Scene& scene, const RadarView& view);

 private:
  double mean_;
  std::shared_ptr<const GuardRails> rails_;
  Random random_;
  std::vector<Eigen::Vector2d> things_;  ///< standing in the field, in the world

  Eigen::Vector2d standing(const Scene& scene, const RadarView& view, std::size_t& looked_at);
  Eigen::Vector2d new_thing(const Scene& scene, const RadarView& view);
  Eigen::Vector2d anywhere(const RadarView& view);
};

}  // namespace lanefuse
