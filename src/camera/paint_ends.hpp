// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "camera/bar_chains.hpp"
#include "camera/parallel_lines.hpp"

namespace lanefuse {

/// Paint that ends within a row fills only a part of it, and its middle lies before or behind the row's. At
/// 110 m a row covers 3.4 m of road and a dash hardly two rows: the bar of an end may then be pixels off the
/// line. How much darker it is than the rest of its chain tells how much of the row is paint, and so where:
/// the bars of a chain's ends are moved there, along the column. All bars get the sigma of their rows.
///
class PaintEnds {
 public:
  /// `blur_px`: sigma of the lens and the chip, beside the pixels' own size.
  explicit PaintEnds(double blur_px) : blur_px_(blur_px) {}

  /// Short chains are compared with the longer ones of their line.
  void settle(std::vector<RoadBar>& bars, std::span<const BarChain> chains, const ParallelLines& lines);

 private:
  struct LinePaint {
    std::size_t line = 0;
    double paint = 0;
  };
  double blur_px_;
  std::vector<LinePaint> long_chains_;  ///< of lines, by line and paint

  void learn(const std::vector<RoadBar>& bars, std::span<const BarChain> chains, const ParallelLines& lines);
  [[nodiscard]] double full_paint(const std::vector<RoadBar>& bars, const BarChain& chain,
                                  const ParallelLines& lines) const;
  void settle_bar(RoadBar& bar, double full, double direction, bool is_long) const;
};

}  // namespace lanefuse
