// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/top_view_layers.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/boundary_curve.hpp"

namespace lanefuse {
namespace {

// The ego vehicle around the middle of its front axle.
constexpr double kEgoFront = 0.9;
constexpr double kEgoRear = -3.8;
constexpr double kEgoWidth = 1.85;

constexpr double kSwitchedOff = 0.5;  // below this a smoothing edge is off

bool is_off(const SwitchState& edge) { return edge.value < kSwitchedOff; }

/// Where `y_at(x)` runs.
template <typename Line>
std::vector<Pixel> curve(const Axes& axes, double from, double to, Line y_at) {
  std::vector<Pixel> pixels;
  for (double x = from; x < to; x += kPointSpacing) pixels.push_back(axes.at(x, y_at(x)));
  if (to > from) pixels.push_back(axes.at(to, y_at(to)));
  return pixels;
}

std::vector<Pixel> curve(const Axes& axes, const Boundary& boundary, double from, double to) {
  return curve(axes, from, to, [&boundary](double x) { return curve_at(boundary, x); });
}

std::vector<Pixel> pixels_of(const Axes& axes, const std::vector<Eigen::Vector2d>& points) {
  std::vector<Pixel> pixels;
  for (const auto& point : points) pixels.push_back(axes.at(point.x(), point.y()));
  return pixels;
}

void draw_band(SvgWriter& svg, const Axes& axes, const Boundary& boundary) {
  std::vector<Pixel> outline;
  for (const BoundaryPoint& point : boundary.points)
    outline.push_back(axes.at(point.x, point.y + point.sigma));
  for (auto point = boundary.points.rbegin(); point != boundary.points.rend(); ++point) {
    outline.push_back(axes.at(point->x, point->y - point->sigma));
  }
  svg.polygon(outline, "ink-boundary band");
}

void draw_ego_wash(SvgWriter& svg, const Axes& axes, const LaneEstimate& estimate) {
  const Lane* lane = ego_lane(estimate);
  if (!lane) return;
  const Boundary& left = *find_boundary(estimate, lane->left_boundary);
  const Boundary& right = *find_boundary(estimate, lane->right_boundary);
  const double from = std::max(left.range_begin, right.range_begin);
  const double to = std::min(left.range_end, right.range_end);
  std::vector<Pixel> outline = curve(axes, left, from, to);
  const std::vector<Pixel> back = curve(axes, right, from, to);
  outline.insert(outline.end(), back.rbegin(), back.rend());
  svg.polygon(outline, "ink-boundary wash");
}

void draw_box(SvgWriter& svg, const Axes& axes, const Pose2& rear, const Eigen::Vector2d& size,
              const char* css) {
  const double half = size.y() / 2;
  std::array<Pixel, 4> corners;
  std::size_t i = 0;
  for (const auto& [along, across] :
       {std::pair{0.0, -half}, {size.x(), -half}, {size.x(), half}, {0.0, half}}) {
    const Eigen::Vector2d corner = rear * Eigen::Vector2d(along, across);
    corners[i++] = axes.at(corner.x(), corner.y());
  }
  svg.polygon(corners, css);
}

template <typename Wanted>
bool any_feature(const DebugView& debug, Wanted wanted) {
  return std::any_of(debug.features.begin(), debug.features.end(), wanted);
}

void add_feature_entries(std::vector<LegendEntry>& entries, const DebugView& debug) {
  for (int i = 0; i < kSourceCount; ++i) {
    const auto source = static_cast<Source>(i);
    if (!any_feature(debug, [source](const auto& f) { return f.feature.source == source && !f.outlier; }))
      continue;
    const SourceStyle style = style_of(source);
    entries.push_back({std::string(style.label), "", style.marker, std::string(style.css)});
  }
  if (any_feature(debug, [](const auto& f) { return f.outlier; })) {
    entries.push_back({"outlier", "", Marker::circle, "outlier"});
  }
}

}  // namespace

std::vector<LegendEntry> top_view_legend(const TopView& view) {
  std::vector<LegendEntry> entries;
  const auto add_line = [&entries](bool present, const char* label, const char* css) {
    if (present) entries.push_back({label, css, std::nullopt, ""});
  };
  const auto& switches = view.debug.switches;
  const bool any_off = std::any_of(switches.begin(), switches.end(), is_off);
  const bool any_on = !std::all_of(switches.begin(), switches.end(), is_off);
  add_line(!view.estimate.boundaries.empty(), "boundary, with 1 sigma", "pen-boundary thick");
  add_line(!view.true_boundaries.empty(), "truth", "pen-truth thin");
  add_line(!view.driven_path.empty(), "path driven later", "pen-truth medium dashed");
  add_line(view.debug.base_clothoid.has_value(), "base clothoid", "pen-base thick");
  add_feature_entries(entries, view.debug);
  add_line(any_on, "smoothing edge", "pen-objects thin faint");
  add_line(any_off, "switched off", "pen-truth thick dashed");
  return entries;
}

void draw_lanes(SvgWriter& svg, const Axes& axes, const LaneEstimate& estimate) {
  draw_ego_wash(svg, axes, estimate);
  for (const Boundary& boundary : estimate.boundaries) {
    draw_band(svg, axes, boundary);
    svg.polyline(curve(axes, boundary, kViewFrom, boundary.range_begin), "pen-boundary thin dotted faint");
    svg.polyline(curve(axes, boundary, boundary.range_end, kViewTo), "pen-boundary thin dotted faint");
    svg.polyline(curve(axes, boundary, boundary.range_begin, std::min(boundary.range_end, kViewTo)),
                 "pen-boundary thick");
  }
}

void draw_truth(SvgWriter& svg, const Axes& axes, const TopView& view) {
  for (const auto& line : view.true_boundaries) svg.polyline(pixels_of(axes, line), "pen-truth thin");
  svg.polyline(pixels_of(axes, view.driven_path), "pen-truth medium dashed");
}

void draw_switches(SvgWriter& svg, const Axes& axes, const DebugView& debug) {
  for (const SwitchState& edge : debug.switches) {
    svg.line(axes.at(edge.from.x(), edge.from.y()), axes.at(edge.to.x(), edge.to.y()),
             is_off(edge) ? "pen-truth thick dashed" : "pen-objects thin faint");
  }
}

void draw_base_clothoid(SvgWriter& svg, const Axes& axes, const DebugView& debug) {
  if (!debug.base_clothoid) return;
  const auto base = curve(axes, 0, kViewTo, [&debug](double x) { return debug.base_clothoid->y(x); });
  svg.polyline(base, "pen-base thick");
}

void draw_features(SvgWriter& svg, const Axes& axes, const DebugView& debug) {
  for (const FusedFeature& fused : debug.features) {
    const SourceStyle style = style_of(fused.feature.source);
    const double size = fused.outlier || fused.in_base_fit ? 2.9 : 1.7;
    const Pixel at = axes.at(fused.feature.x, fused.feature.y);
    draw_marker(svg, style.marker, at, size, fused.outlier ? "outlier" : style.css);
  }
}

void draw_vehicles(SvgWriter& svg, const Axes& axes, const TopView& view) {
  for (const TrackedObject& vehicle : view.vehicles) {
    draw_box(svg, axes, {vehicle.x, vehicle.y, vehicle.heading}, {vehicle.length, vehicle.width},
             "pen-vehicle thin ink-vehicle band");
  }
  draw_box(svg, axes, {kEgoRear, 0, 0}, {kEgoFront - kEgoRear, kEgoWidth}, "ink-vehicle");
}

}  // namespace lanefuse
