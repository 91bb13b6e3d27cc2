// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/overlay_legend.hpp"

#include <array>

#include "drawing/overlay_colours.hpp"

namespace lanefuse {
namespace {

constexpr double kTextSize = 9;      // [px]
constexpr double kSampleWidth = 26;  // [px]
constexpr double kGap = 20;          // [px] between entries

void draw_window_sample(Canvas& canvas, const Pixel& at, double half, Colour colour, bool found) {
  const Pen pen{colour, 1};
  canvas.line(at - Pixel(half, 0), at + Pixel(half, 0), pen);
  for (const double side : {-half, half}) canvas.line(at + Pixel(side, -4), at + Pixel(side, 4), pen);
  if (found) canvas.disc(at, 3, colour);
}

}  // namespace

void draw_sample(Canvas& canvas, OverlaySample sample, const Pixel& at, double size, Colour colour) {
  const auto around = [&](double x, double y) -> Pixel { return at + size * Pixel(x, y); };
  switch (sample) {
    case OverlaySample::line:
      return canvas.line(around(-1, 0), around(1, 0), {colour, 3});
    case OverlaySample::dashed_line:
      return canvas.line(around(-1, 0), around(1, 0), {colour, 2, 6});
    case OverlaySample::bar:
      return canvas.line(around(-1, 0), around(1, 0), {colour, 3});
    case OverlaySample::faint_bar:
      return canvas.line(around(-1, 0), around(1, 0), {colour, 1});
    case OverlaySample::window:
      return draw_window_sample(canvas, at, size, colour, true);
    case OverlaySample::faint_window:
      return draw_window_sample(canvas, at, size, colour, false);
    case OverlaySample::box:
      return canvas.rectangle({at.x() - size, at.y() - size * .6, 2 * size, size * 1.2}, {colour, 2});
    case OverlaySample::circle:
      return canvas.disc(at, size, colour);
    case OverlaySample::triangle:
      return canvas.fill(std::array{around(0, -1.2), around(1.1, .8), around(-1.1, .8)}, colour);
    case OverlaySample::diamond:
      return canvas.fill(std::array{around(0, -1.3), around(1.3, 0), around(0, 1.3), around(-1.3, 0)},
                         colour);
    case OverlaySample::cross:
      canvas.line(around(-1, -1), around(1, 1), {colour, 1});
      return canvas.line(around(-1, 1), around(1, -1), {colour, 1});
  }
}

void draw_overlay_legend(Canvas& canvas, const Box& box, std::span<const OverlayLegendEntry> entries) {
  const double middle = box.top + box.height / 2;
  double left = box.left;
  for (const auto& [label, sample, colour] : entries) {
    const double width = kSampleWidth + 6 + Canvas::text_width(label, kTextSize);
    if (left + width > box.right()) return;
    const bool long_sample = sample <= OverlaySample::faint_window;
    const double size = sample == OverlaySample::box ? 9 : long_sample ? kSampleWidth / 2 - 2 : 4;
    draw_sample(canvas, sample, {left + kSampleWidth / 2, middle}, size, colour);
    canvas.text({left + kSampleWidth + 6, middle + kTextSize / 2}, label, overlay_colour::kText, kTextSize);
    left += width + kGap;
  }
}

}  // namespace lanefuse
