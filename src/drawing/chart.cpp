// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/chart.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "core/percentile.hpp"
#include "drawing/legend.hpp"

namespace lanefuse {
namespace {

constexpr double kWidth = 560;
constexpr double kPlotHeight = 236;
constexpr double kLeft = 46;
constexpr double kTitleLeft = 4;
constexpr double kRight = 18;
constexpr double kInner = kWidth - kLeft - kRight;

std::string line_css(const Series& series) {
  return fmt::format("pen-{} {}{}", series.colour, series.marker ? "medium" : "thin",
                     series.dashed ? " dashed" : "");
}

std::vector<LegendEntry> legend_of(const std::vector<Series>& series) {
  std::vector<LegendEntry> entries;
  for (const Series& one : series) {
    if (!one.label.empty()) entries.push_back({one.label, line_css(one), one.marker, one.colour});
  }
  return entries;
}

void draw_series(SvgWriter& svg, const Axes& axes, const Series& series) {
  std::vector<Pixel> pixels;
  for (const Eigen::Vector2d& point : series.points) pixels.push_back(axes.at(point.x(), point.y()));
  svg.polyline(pixels, line_css(series) + " round");
  if (!series.marker) return;
  for (const Pixel& pixel : pixels) draw_marker(svg, *series.marker, pixel, 3.2, series.colour);
}

void say_no_data(SvgWriter& svg, const Axes& axes) {
  const Box& frame = axes.frame();
  svg.text({frame.left + frame.width / 2, frame.top + frame.height / 2}, "no data", "heading ink-muted",
           Anchor::middle);
}

bool has_data(const Chart& chart) {
  return std::any_of(chart.series.begin(), chart.series.end(), [](const Series& series) {
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const auto& point) { return point.allFinite(); });
  });
}

/// How many values fall into each of the steps from 0 to the axis's end.
std::vector<double> counts(const std::vector<double>& values, double width, std::size_t bins) {
  std::vector<double> result(bins, 0.0);
  for (const double value : values) {
    result[std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, value) / width))] += 1;
  }
  return result;
}

void draw_bars(SvgWriter& svg, const Axes& axes, const std::vector<double>& heights, double width) {
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (heights[i] == 0) continue;
    const Pixel top = axes.at(static_cast<double>(i) * width, heights[i]);
    const Pixel foot = axes.at(static_cast<double>(i + 1) * width, 0);
    svg.rectangle({top.x() + 0.5, top.y(), std::max(0.5, foot.x() - top.x() - 1), foot.y() - top.y()},
                  "ink-series-0");
  }
}

}  // namespace

Figure draw_chart(const Chart& chart) {
  const std::vector<LegendEntry> legend = legend_of(chart.series);
  const double top = 34 + legend_height(kInner, legend) + 22;
  const Axes axes({kLeft, top, kInner, kPlotHeight}, chart.x, chart.y);
  SvgWriter svg;
  svg.text({kTitleLeft, 20}, chart.title, "heading ink-text");
  draw_legend(svg, {kTitleLeft, 42}, kInner, legend);
  axes.draw(svg);
  if (!has_data(chart)) say_no_data(svg, axes);
  for (const Series& series : chart.series) draw_series(svg, axes, series);
  return {kWidth, top + kPlotHeight + 44, chart.title, svg.elements()};
}

Figure draw_cycle_times(const std::vector<double>& cycle_ms) {
  const char* title = "Cycle time";
  constexpr double kTop = 75;
  const double largest = cycle_ms.empty() ? 0 : *std::max_element(cycle_ms.begin(), cycle_ms.end());
  const Axis x = axis_from_zero("cycle time [ms]", largest, 8);
  const double width = x.step / 5;
  const auto bins = static_cast<std::size_t>(std::lround(x.to / width));
  const std::vector<double> heights = counts(cycle_ms, width, bins);
  const Axes axes({kLeft, kTop, kInner, kPlotHeight}, x,
                  axis_from_zero("cycles", *std::max_element(heights.begin(), heights.end()), 6));
  SvgWriter svg;
  svg.text({kTitleLeft, 20}, title, "heading ink-text");
  axes.draw(svg);
  if (cycle_ms.empty()) {
    say_no_data(svg, axes);
    return {kWidth, kTop + kPlotHeight + 44, title, svg.elements()};
  }
  draw_bars(svg, axes, heights, width);
  std::vector<LegendEntry> legend;
  for (const auto& [name, share, colour] :
       {std::tuple{"p50", 0.5, "series-3"}, {"p99", 0.99, "series-1"}, {"max", 1.0, "truth"}}) {
    const double value = percentile(cycle_ms, share);
    const std::string css = fmt::format("pen-{} medium dashed", colour);
    svg.line(axes.at(value, axes.y().from), axes.at(value, axes.y().to), css);
    legend.push_back({fmt::format("{} {:.2f} ms", name, value), css, std::nullopt, ""});
  }
  draw_legend(svg, {kTitleLeft, 42}, kInner, legend);
  return {kWidth, kTop + kPlotHeight + 44, title, svg.elements()};
}

}  // namespace lanefuse
