// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/style.hpp"
#include "drawing/svg.hpp"

namespace lanefuse {

/// One line of a legend: a sample of a line, of a marker, or of both on each other.
struct LegendEntry {
  std::string label;
  std::string line_css;  ///< empty: no line
  std::optional<Marker> marker;
  std::string marker_css;
};

/// Lays the entries out in rows of at most `width` from `at` on, the middle of the first row's height;
/// returns the height that they take [px].
double draw_legend(SvgWriter& svg, const Pixel& at, double width, const std::vector<LegendEntry>& entries);

/// The same without drawing.
double legend_height(double width, const std::vector<LegendEntry>& entries);

}  // namespace lanefuse
