// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/top_view.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawing/axes.hpp"
#include "drawing/legend.hpp"
#include "drawing/top_view_layers.hpp"
#include "evaluation/true_road_view.hpp"

namespace lanefuse {
namespace {

constexpr double kWidth = 1140;
constexpr double kPlotHeight = 330;
constexpr double kLeft = 46;
constexpr double kTitleLeft = 4;
constexpr double kInner = kWidth - kLeft - 18;

/// Stretches a lateral range over what is drawn within sight, but not over what flies away.
class LateralRange {
 public:
  void include(double x, double y) {
    if (x < kViewFrom || x > kViewTo || !(std::abs(y) < kWidest)) return;
    lowest_ = std::min(lowest_, y);
    highest_ = std::max(highest_, y);
  }
  [[nodiscard]] Axis axis() const {
    const double step = nice_step(highest_ - lowest_ + 2, 10);
    return {"lateral [m]", std::floor(lowest_ - 1), std::ceil(highest_ + 1), step};
  }

 private:
  static constexpr double kWidest = 40;
  double lowest_ = -5;
  double highest_ = 5;
};

Axis lateral_axis(const TopView& view) {
  LateralRange range;
  for (const auto& line : view.true_boundaries) {
    for (const auto& point : line) range.include(point.x(), point.y());
  }
  for (const auto& point : view.driven_path) range.include(point.x(), point.y());
  for (const FusedFeature& fused : view.debug.features) range.include(fused.feature.x, fused.feature.y);
  for (const Boundary& boundary : view.estimate.boundaries) {
    for (double x = boundary.range_begin; x <= boundary.range_end; x += 5)
      range.include(x, lateral_at(boundary, x));
  }
  return range.axis();
}

std::string status_line(const LaneEstimate& estimate) {
  std::string text = fmt::format("status {}", to_string(estimate.status));
  if (estimate.reason != StatusReason::none) text += fmt::format(" ({})", to_string(estimate.reason));
  return text + fmt::format(", {:.0f} km/h", estimate.speed * 3.6);
}

}  // namespace

std::vector<std::vector<Eigen::Vector2d>> boundaries_in_view(const TrueRoad& road,
                                                             const Pose2& world_from_vehicle) {
  std::vector<std::vector<Eigen::Vector2d>> result;
  TrueRoadView view(road);
  for (const LineAhead& line : view.look_from(world_from_vehicle)) {
    if (line.points().size() > 1) result.push_back(line.points());
  }
  return result;
}

Figure draw_top_view(const TopView& view) {
  const std::vector<LegendEntry> legend = top_view_legend(view);
  const double top = 34 + legend_height(kInner, legend) + 22;
  const Axes axes({kLeft, top, kInner, kPlotHeight}, {"ahead [m]", kViewFrom, kViewTo, 10},
                  lateral_axis(view));
  SvgWriter svg;
  svg.text({kTitleLeft, 20}, view.title, "heading ink-text");
  svg.text({kLeft + kInner, 20}, status_line(view.estimate), "label ink-muted", Anchor::end);
  draw_legend(svg, {kTitleLeft, 42}, kInner, legend);
  axes.draw(svg);
  svg.begin_clip(axes.frame());
  draw_lanes(svg, axes, view.estimate);
  draw_truth(svg, axes, view);
  draw_switches(svg, axes, view.debug);
  draw_base_clothoid(svg, axes, view.debug);
  draw_features(svg, axes, view.debug);
  draw_vehicles(svg, axes, view);
  svg.end_clip();
  return {kWidth, top + kPlotHeight + 44, "top view: " + view.title, svg.elements()};
}

}  // namespace lanefuse
