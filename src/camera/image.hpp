// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lanefuse {

/// Pixels that belong to someone else: rows of 8-bit channels, blue-green-red or grey.
struct ImageView {
  const std::uint8_t* data = nullptr;
  int width = 0;              ///< [px]
  int height = 0;             ///< [px]
  int channels = 3;           ///< 3: blue, green, red; 1: grey
  std::ptrdiff_t stride = 0;  ///< [bytes] from one row to the next

  [[nodiscard]] bool empty() const { return width == 0 || height == 0; }
  [[nodiscard]] const std::uint8_t* row(int v) const {
    assert(0 <= v && v < height);
    return data + v * stride;
  }
};

/// Pixels without gaps between rows.
class Image {
 public:
  Image() = default;
  Image(int width, int height, int channels)
      : width_(width),
        height_(height),
        channels_(channels),
        data_(static_cast<std::size_t>(width) * height * channels) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int channels() const { return channels_; }
  [[nodiscard]] bool empty() const { return data_.empty(); }
  [[nodiscard]] std::uint8_t* row(int v) {
    assert(0 <= v && v < height_);
    return data_.data() + static_cast<std::ptrdiff_t>(v) * width_ * channels_;
  }
  [[nodiscard]] ImageView view() const {
    return {data_.data(), width_, height_, channels_, static_cast<std::ptrdiff_t>(width_) * channels_};
  }

 private:
  int width_ = 0;
  int height_ = 0;
  int channels_ = 3;
  std::vector<std::uint8_t> data_;
};

}  // namespace lanefuse
