// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/reduced_image.hpp"

#include <algorithm>
#include <cassert>

namespace lanefuse {
namespace {

/// Adds the brightness of one row's pixels, times four, to the sums of their blocks.
void add_row(const ImageView& image, int row, int factor, std::vector<int>& sums) {
  const std::uint8_t* pixel = image.row(row);
  for (int& sum : sums) {
    for (int i = 0; i < factor; ++i, pixel += image.channels) {
      sum += image.channels == 3 ? pixel[0] + 2 * pixel[1] + pixel[2] : 4 * pixel[0];
    }
  }
}

}  // namespace

Reduction reduction_to(int columns, int image_width, int first_row, int end_row) {
  Reduction reduction;
  reduction.factor = std::max(1, (image_width + columns / 2) / columns);
  reduction.first_row = first_row;
  reduction.width = image_width / reduction.factor;
  reduction.height = std::max(0, end_row - first_row) / reduction.factor;
  return reduction;
}

NumberImage reduced_brightness(const ImageView& image, const Reduction& reduction) {
  assert(reduction.width * reduction.factor <= image.width);
  assert(reduction.first_row >= 0 &&
         reduction.first_row + reduction.height * reduction.factor <= image.height);
  NumberImage reduced(reduction.width, reduction.height);
  const float scale = 1.0F / static_cast<float>(4 * reduction.factor * reduction.factor);
  std::vector<int> sums(static_cast<std::size_t>(reduction.width));
  for (int v = 0; v < reduction.height; ++v) {
    std::fill(sums.begin(), sums.end(), 0);
    for (int i = 0; i < reduction.factor; ++i) {
      add_row(image, reduction.first_row + v * reduction.factor + i, reduction.factor, sums);
    }
    std::transform(sums.begin(), sums.end(), reduced.row(v),
                   [scale](int sum) { return static_cast<float>(sum) * scale; });
  }
  return reduced;
}

}  // namespace lanefuse
