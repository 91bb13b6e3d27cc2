// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "camera/reduced_image.hpp"
#include "camera/vehicle_shapes.hpp"

namespace lanefuse {

/// Sums over rectangles of an image in no time.
class SummedImage {
 public:
  SummedImage() = default;
  explicit SummedImage(const NumberImage& image);
  /// The mean within a box, whose edges are rounded and cut to the image; 0 where nothing is left.
  [[nodiscard]] double mean(const PixelBox& box) const;

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<double> sums_;
};

/// What speaks for a vehicle in a box, each in [0, 1].
struct VehicleEvidence {
  double shadow = 0;      ///< dark under the car, brighter road before it
  double left_edge = 0;   ///< upright
  double right_edge = 0;  ///< upright
  double motion = 0;      ///< does not move as the road does
  double body = 0;        ///< something to see in the middle of it, more than on the road before it

  [[nodiscard]] double score() const;
};

/// Everything that boxes of one image are judged by.
class VehicleCues {
 public:
  /// `brightness` of the image, and how much each pixel differs from what the road's motion makes of the
  /// image before (empty: the first image).
  VehicleCues(const NumberImage& brightness, const NumberImage& residual);
  [[nodiscard]] VehicleEvidence evidence(const VehicleShape& shape) const;

  /// The shadow alone, which tells most and costs least.
  [[nodiscard]] double shadow(const VehicleShape& shape) const;

  /// The shape with its box's left, right and lower edges moved a little to where they fit best.
  [[nodiscard]] VehicleShape refined(VehicleShape shape) const;

 private:
  SummedImage brightness_;
  SummedImage upright_;
  SummedImage level_;
  SummedImage residual_;
  bool has_residual_;

  [[nodiscard]] double edge(const PixelBox& box, double column, double outward) const;
};

}  // namespace lanefuse
