// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/axes.hpp"

#include <cmath>

#include <fmt/format.h>

namespace lanefuse {
namespace {

std::string tick_label(double value, double step) {
  int decimals = 0;
  for (double left = step; decimals < 6 && std::abs(left - std::round(left)) > 1e-6; left *= 10) ++decimals;
  return fmt::format("{:.{}f}", value == 0 ? 0.0 : value, decimals);
}

/// Calls `visit(value)` at each tick; counted in whole steps, so that rounding does not add up.
template <typename Visit>
void for_each_tick(const Axis& axis, Visit visit) {
  const auto first = static_cast<long>(std::ceil(axis.from / axis.step - 1e-9));
  const auto last = static_cast<long>(std::floor(axis.to / axis.step + 1e-9));
  for (long i = first; i <= last; ++i) visit(static_cast<double>(i) * axis.step);
}

}  // namespace

double nice_step(double span, int most) {
  const double least = span / most;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= least * (1 - 1e-9)) return factor * decade;
  }
  return 10 * decade;
}

Axis axis_from_zero(std::string label, double largest, int most_ticks) {
  if (!std::isfinite(largest) || largest <= 0) largest = 1;
  const double step = nice_step(largest, most_ticks);
  return {std::move(label), 0, step * std::ceil(largest / step - 1e-9), step};
}

Pixel Axes::at(double x, double y) const {
  return {frame_.left + frame_.width * (x - x_.from) / (x_.to - x_.from),
          frame_.bottom() - frame_.height * (y - y_.from) / (y_.to - y_.from)};
}

void Axes::draw(SvgWriter& svg) const {
  draw_x(svg);
  draw_y(svg);
  svg.rectangle(frame_, "pen-frame hair");
}

void Axes::draw_x(SvgWriter& svg) const {
  for_each_tick(x_, [&](double x) {
    const Pixel foot = at(x, y_.from);
    svg.line({foot.x(), frame_.top}, foot, "pen-grid hair");
    svg.text({foot.x(), frame_.bottom() + 16}, tick_label(x, x_.step), "tick number ink-muted",
             Anchor::middle);
  });
  svg.text({frame_.left + frame_.width / 2, frame_.bottom() + 33}, x_.label, "label ink-text",
           Anchor::middle);
}

void Axes::draw_y(SvgWriter& svg) const {
  for_each_tick(y_, [&](double y) {
    const Pixel foot = at(x_.from, y);
    svg.line(foot, {frame_.right(), foot.y()}, "pen-grid hair");
    svg.text({foot.x() - 7, foot.y() + 4}, tick_label(y, y_.step), "tick number ink-muted", Anchor::end);
  });
  // Above the axis instead of turned by a quarter: it reads without tilting the head.
  svg.text({4, frame_.top - 10}, y_.label, "label ink-text");
}

}  // namespace lanefuse
