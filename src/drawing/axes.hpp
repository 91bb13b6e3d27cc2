// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "drawing/svg.hpp"

namespace lanefuse {

/// One axis of a picture: what it shows, from where to where, and how far apart the ticks are.
struct Axis {
  std::string label;  ///< with its unit: "distance ahead [m]"
  double from = 0;
  double to = 1;
  double step = 1;
};

/// A step of 1, 2 or 5 times a power of ten that divides `span` > 0 into at most `most` parts.
double nice_step(double span, int most);

/// An axis from 0 to the next tick above `largest`; to 1 where that is nothing sensible.
Axis axis_from_zero(std::string label, double largest, int most_ticks);

/// A framed area of a picture with its two axes.
class Axes {
 public:
  Axes(const Box& frame, Axis x, Axis y) : frame_(frame), x_(std::move(x)), y_(std::move(y)) {}

  [[nodiscard]] Pixel at(double x, double y) const;
  [[nodiscard]] const Box& frame() const { return frame_; }
  [[nodiscard]] const Axis& x() const { return x_; }
  [[nodiscard]] const Axis& y() const { return y_; }

  /// Grid, ticks and labels: what lies behind the data.
  void draw(SvgWriter& svg) const;

 private:
  void draw_x(SvgWriter& svg) const;
  void draw_y(SvgWriter& svg) const;

  Box frame_;
  Axis x_;
  Axis y_;
};

}  // namespace lanefuse
