// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "camera/image.hpp"

namespace lanefuse {

/// A piece of one row that is brighter, or yellower, than the road on both of its sides.
struct BrightBar {
  int row = 0;       ///< [px]
  double left = 0;   ///< [px] column of its left edge
  double right = 0;  ///< [px] column of its right edge
};

/// Bars in the image's lower 60 %, of any width up to a sixteenth of the image: nothing need be known of how
/// the camera stands. Where it is known, MarkingExtractor finds more and believes less.
std::vector<BrightBar> find_bright_bars(const ImageView& image, int contrast);

}  // namespace lanefuse
