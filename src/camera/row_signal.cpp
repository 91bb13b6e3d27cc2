// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/row_signal.hpp"

#include <algorithm>
#include <opencv2/core.hpp>

namespace lanefuse {
namespace {

/// [grey levels] by which grey things may look yellow in warm light without being told from grey.
constexpr int kTint = 24;

struct Planes {
  const std::uint8_t* blue;
  const std::uint8_t* green;
  const std::uint8_t* red;
};

void add_colours(const Planes& planes, int count, std::uint16_t* levels) {
  for (int i = 0; i < count; ++i) {
    const int blue = planes.blue[i];
    const int green = planes.green[i];
    const int red = planes.red[i];
    const int grey = (blue + 2 * green + red + 2) / 4;
    const int yellow = std::max(0, std::min(green, red) - blue - kTint);
    levels[i] = static_cast<std::uint16_t>(levels[i] + grey + yellow);
  }
}

}  // namespace

RowSignal::RowSignal(int width)
    : planes_(3 * static_cast<std::size_t>(width)),
      levels_(static_cast<std::size_t>(width)),
      sums_(static_cast<std::size_t>(width) + 1) {}

void RowSignal::add(const ImageView& image, int row) {
  const int count = end_ - begin_;
  const std::uint8_t* pixels = image.row(row) + static_cast<std::ptrdiff_t>(begin_) * image.channels;
  std::uint16_t* levels = levels_.data() + begin_;
  if (image.channels == 1) {
    for (int i = 0; i < count; ++i) levels[i] = static_cast<std::uint16_t>(levels[i] + pixels[i]);
    return;
  }
  const std::ptrdiff_t width = image.width;
  std::uint8_t* const planes[] = {planes_.data(), planes_.data() + width, planes_.data() + 2 * width};
  // OpenCV only reads from here.
  const cv::Mat interleaved(1, count, CV_8UC3, const_cast<std::uint8_t*>(pixels));
  cv::Mat separate[] = {cv::Mat(1, count, CV_8UC1, planes[0]), cv::Mat(1, count, CV_8UC1, planes[1]),
                        cv::Mat(1, count, CV_8UC1, planes[2])};
  cv::split(interleaved, separate);
  add_colours({planes[0], planes[1], planes[2]}, count, levels);
}

void RowSignal::read(const ImageView& image, const PlannedRow& row) {
  begin_ = row.begin;
  end_ = std::max(row.begin, row.end);
  rows_ = row.height();
  if (begin_ == end_) return;
  std::fill(levels_.begin() + begin_, levels_.begin() + end_, std::uint16_t{0});
  for (int v = row.row - row.half_height; v <= row.row + row.half_height; ++v) add(image, v);
  std::int32_t sum = 0;
  sums_[static_cast<std::size_t>(begin_)] = 0;
  for (int u = begin_; u < end_; ++u) {
    sum += levels_[static_cast<std::size_t>(u)];
    sums_[static_cast<std::size_t>(u) + 1] = sum;
  }
}

}  // namespace lanefuse
