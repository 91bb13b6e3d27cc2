// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/axes.hpp"
#include "drawing/style.hpp"
#include "drawing/svg.hpp"

namespace lanefuse {

/// A line of a chart. Values that are not finite are gaps.
struct Series {
  std::string label;  ///< empty: not in the legend
  std::vector<Eigen::Vector2d> points;
  std::string colour;            ///< one of the colours of figure_css()
  std::optional<Marker> marker;  ///< at each point; reference lines have none, and are thin
  bool dashed = false;
};

struct Chart {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
};

/// Lines over axes, with a legend; says "no data" where no series has a point.
Figure draw_chart(const Chart& chart);

/// How often each cycle time came, with the percentiles that matter marked; `cycle_ms` in any order, empty
/// says so.
Figure draw_cycle_times(const std::vector<double>& cycle_ms);

}  // namespace lanefuse
