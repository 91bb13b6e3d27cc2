// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "camera/image.hpp"

namespace lanefuse {

/// A picture of numbers, row after row.
struct NumberImage {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  NumberImage() = default;
  NumberImage(int columns, int rows)
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
  [[nodiscard]] const float* row(int v) const {
    return values.data() + static_cast<std::ptrdiff_t>(v) * width;
  }
  [[nodiscard]] float* row(int v) { return values.data() + static_cast<std::ptrdiff_t>(v) * width; }
};

/// Which rows of a camera's image are looked at, and how coarsely: each pixel of the reduced image is the
/// mean of factor x factor pixels.
struct Reduction {
  int factor = 1;
  int first_row = 0;  ///< [px] of the camera's image
  int width = 0;      ///< [px] of the reduced image
  int height = 0;     ///< [px] of the reduced image

  [[nodiscard]] double full_column(double column) const { return (column + 0.5) * factor - 0.5; }
  [[nodiscard]] double full_row(double row) const { return first_row + (row + 0.5) * factor - 0.5; }
  [[nodiscard]] double column(double full) const { return (full + 0.5) / factor - 0.5; }
  [[nodiscard]] double row(double full) const { return (full - first_row + 0.5) / factor - 0.5; }
};

/// Rows first_row to end_row, at about `columns` pixels a row.
Reduction reduction_to(int columns, int image_width, int first_row, int end_row);

/// Brightness (the mean of green and half of red and blue; grey images as they are) in [0, 255].
NumberImage reduced_brightness(const ImageView& image, const Reduction& reduction);

}  // namespace lanefuse
