// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/marking_sight.hpp"

#include <optional>

namespace lanefuse {
namespace {

/// The measurement of a window that fitted the lane.
std::optional<std::size_t> fitted(const SearchedWindow& window, const LaneFilter::Fit& fit) {
  for (int i = window.first_edge; i < window.first_edge + window.edge_count; ++i) {
    if (fit.inlier[static_cast<std::size_t>(i)]) return static_cast<std::size_t>(i);
  }
  return {};
}

}  // namespace

MarkingSight judge_marking(const EdgeSearch& search, const LaneFilter::Fit& fit, Side side) {
  // Dashed markings have gaps of up to 12 m, of which a rut or a shadow may hide an end.
  constexpr double kLargestGap = 20;  // [m]
  MarkingSight sight;
  int looked = 0;
  int looked_to_end = 0;
  std::optional<double> last;
  for (const SearchedWindow& window : search.windows()) {
    if (window.side != side) continue;
    if (!last) last = window.distance;
    if (window.distance - *last > kLargestGap) break;
    if (window.hidden) continue;
    ++looked;
    if (!fitted(window, fit)) {
      sight.open += window.edge_count > 0 ? 1 : 0;
      continue;
    }
    if (sight.found == 0) sight.begin = window.distance;
    last = sight.end = window.distance;
    ++sight.found;
    looked_to_end = looked;
  }
  if (looked_to_end > 0) sight.support = static_cast<double>(sight.found) / looked_to_end;
  return sight;
}

void remember_paint(const EdgeSearch& search, const LaneFilter::Fit& fit, std::array<PaintMemory, 2>& paint) {
  constexpr double kSharpWidth = 6;   // [px]
  constexpr double kSharpRange = 25;  // [m]
  for (const SearchedWindow& window : search.windows()) {
    if (window.hidden) continue;
    PaintMemory& memory = paint[window.side == Side::left ? 0 : 1];
    const auto number = fitted(window, fit);
    memory.look(window.distance, number.has_value());
    if (!number) continue;
    const PaintBar& bar = search.bar(*number);
    const double pixels = bar.right - bar.left;
    const bool sharp = pixels > kSharpWidth && window.distance < kSharpRange;
    memory.note(bar.yellow, sharp ? std::optional(pixels * window.metres_per_pixel) : std::nullopt);
  }
}

void list_windows(const EdgeSearch& search, const LaneFilter::Fit& fit, std::vector<SearchWindow>& windows) {
  for (const SearchedWindow& searched : search.windows()) {
    const auto number = fitted(searched, fit);
    const double column = number ? search.edges()[*number].column : 0;
    windows.push_back(
        {searched.row, searched.left, searched.right, searched.side, number.has_value(), column});
  }
}

}  // namespace lanefuse
