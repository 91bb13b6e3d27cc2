// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "drawing/svg.hpp"

namespace lanefuse {

/// Lays a piece of the world into a picture: one scale for both axes, nothing stretched.
class MapFrame {
 public:
  /// Fits all `points` [m] into a picture of that width and at most that height, with a margin; the height is
  /// what they need. `angle` [rad] turns the world before.
  MapFrame(std::span<const Eigen::Vector2d> points, double width, double most_height, double angle = 0);

  [[nodiscard]] Pixel at(const Eigen::Vector2d& point) const;
  [[nodiscard]] double height() const { return height_; }

  /// A bar of a round length at the lower left, and an arrow to the north (the world's y axis).
  void draw_scale(SvgWriter& svg) const;

  static constexpr double kMargin = 34;  ///< [px]

 private:
  double angle_;
  Eigen::Vector2d lowest_{0, 0};  // turned world
  double width_;
  double height_;
  double pixels_per_metre_ = 1;
  double slack_ = 0;  // [px] left of the world, where the height is what limits the scale
};

/// The angle that lays the longest extent of `points` along the picture's width.
double levelling_angle(std::span<const Eigen::Vector2d> points);

}  // namespace lanefuse
