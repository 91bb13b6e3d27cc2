// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "camera/image.hpp"

namespace lanefuse {

/// A piece of one row that is brighter, or yellower, than the road on both of its sides.
struct BrightBar {
  int row = 0;            ///< [px]
  double left = 0;        ///< [px] column of its left edge
  double right = 0;       ///< [px] column of its right edge
  bool yellower = false;  ///< found by its colour, else by its brightness

  [[nodiscard]] double middle() const { return (left + right) / 2; }
};

/// Bars in the image's lower 60 %, of any width up to a sixteenth of the image: nothing need be known of how
/// the camera stands. Where it is known, MarkingExtractor finds more and believes less.
std::vector<BrightBar> find_bright_bars(const ImageView& image, int contrast);

/// Bars of neighbouring rows that continue one another, from top to bottom: a stripe of paint, or a part of
/// one. Those shorter than `fewest_rows` are left out.
std::vector<std::vector<BrightBar>> chain_bars(const std::vector<BrightBar>& bars, std::size_t fewest_rows);

}  // namespace lanefuse
