// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "drawing/canvas.hpp"

namespace lanefuse {

/// How something looks in an overlay.
enum class OverlaySample {
  line,
  dashed_line,
  bar,           ///< a short, level stroke
  faint_bar,     ///< a thin one
  window,        ///< a level line with ends, and a point in it
  faint_window,  ///< without the point
  box,
  circle,
  triangle,
  diamond,
  cross,
};

struct OverlayLegendEntry {
  std::string label;
  OverlaySample sample;
  Colour colour;
};

/// One row, from the left of `box` on; entries that find no room are left out.
void draw_overlay_legend(Canvas& canvas, const Box& box, std::span<const OverlayLegendEntry> entries);

/// The small figure of a point-like sample around `at`; `size` is about its half width [px].
void draw_sample(Canvas& canvas, OverlaySample sample, const Pixel& at, double size, Colour colour);

}  // namespace lanefuse
