// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/legend.hpp"

namespace lanefuse {
namespace {

constexpr double kLineSample = 22;
constexpr double kMarkerSample = 9;
constexpr double kGap = 18;
constexpr double kRow = 19;
constexpr double kCharacter = 6.3;  // mean width at the label's size

double sample_of(const LegendEntry& entry) { return entry.line_css.empty() ? kMarkerSample : kLineSample; }

double width_of(const LegendEntry& entry) {
  return sample_of(entry) + 6 + kCharacter * static_cast<double>(entry.label.size()) + kGap;
}

/// Calls `place(entry, offset)` for each entry and returns the height of all rows.
template <typename Place>
double lay_out(double width, const std::vector<LegendEntry>& entries, Place place) {
  Pixel offset(0, 0);
  for (const LegendEntry& entry : entries) {
    if (offset.x() > 0 && offset.x() + width_of(entry) - kGap > width) offset = {0, offset.y() + kRow};
    place(entry, offset);
    offset.x() += width_of(entry);
  }
  return entries.empty() ? 0 : offset.y() + kRow;
}

}  // namespace

double draw_legend(SvgWriter& svg, const Pixel& at, double width, const std::vector<LegendEntry>& entries) {
  return lay_out(width, entries, [&](const LegendEntry& entry, const Pixel& offset) {
    const Pixel begin = at + offset;
    const double sample = sample_of(entry);
    if (!entry.line_css.empty()) svg.line(begin, begin + Pixel(sample, 0), entry.line_css);
    if (entry.marker) draw_marker(svg, *entry.marker, begin + Pixel(sample / 2, 0), 3.2, entry.marker_css);
    svg.text(begin + Pixel(sample + 6, 4), entry.label, "label ink-text");
  });
}

double legend_height(double width, const std::vector<LegendEntry>& entries) {
  return lay_out(width, entries, [](const LegendEntry&, const Pixel&) {});
}

}  // namespace lanefuse
