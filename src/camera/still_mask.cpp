// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/still_mask.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lanefuse {
namespace {

constexpr int kParts = 64;  ///< of a grey level in what is remembered
constexpr int kPhases = 4;  ///< looks until every row has been looked at
constexpr int kArm = 2;     ///< [px] to either side of a gradient
constexpr int kSearch = 2;  ///< [px] by which edges may be found elsewhere than they are remembered

}  // namespace

StillMask::StillMask(int width, int height, const StillMaskConfig& config)
    : config_(config), width_(width), first_row_(static_cast<int>(config.first_row * height)) {
  const auto rows = static_cast<std::size_t>(std::max(0, (height - first_row_) / config.row_step));
  mean_.resize(rows * static_cast<std::size_t>(width));
  size_.resize(mean_.size());
  looks_.resize(rows);
}

void StillMask::reset() {
  std::fill(mean_.begin(), mean_.end(), std::int16_t{0});
  std::fill(size_.begin(), size_.end(), std::int16_t{0});
  std::fill(looks_.begin(), looks_.end(), 0);
}

void StillMask::learn_row(const ImageView& image, std::size_t index) {
  const std::uint8_t* pixels = image.row(first_row_ + static_cast<int>(index) * config_.row_step);
  const int step = image.channels;
  pixels += step / 2;  // green, or grey
  std::int16_t* mean = mean_.data() + index * static_cast<std::size_t>(width_);
  std::int16_t* size = size_.data() + index * static_cast<std::size_t>(width_);
  // The first looks are averaged as they are; later ones forget the earlier.
  looks_[index] = std::min(looks_[index] + 1, config_.looks);
  const int weight = 256 / looks_[index];
  for (int u = kArm; u < width_ - kArm; ++u) {
    const int gradient = kParts * (pixels[(u + kArm) * step] - pixels[(u - kArm) * step]);
    mean[u] = static_cast<std::int16_t>(mean[u] + (gradient - mean[u]) * weight / 256);
    size[u] = static_cast<std::int16_t>(size[u] + (std::abs(gradient) - size[u]) * weight / 256);
  }
}

void StillMask::learn(const ImageView& image, double distance_moved) {
  moved_ += distance_moved;
  if (!(moved_ >= config_.spacing)) return;
  moved_ = 0;
  for (std::size_t i = static_cast<std::size_t>(phase_); i < looks_.size(); i += kPhases) learn_row(image, i);
  phase_ = (phase_ + 1) % kPhases;
}

bool StillMask::holds_edge(std::size_t index, double column, int sign) const {
  const int middle = static_cast<int>(std::lround(column));
  const std::size_t begin = index * static_cast<std::size_t>(width_);
  for (int u = std::max(0, middle - kSearch); u <= std::min(width_ - 1, middle + kSearch); ++u) {
    const int mean = mean_[begin + static_cast<std::size_t>(u)] * sign;
    const int size = size_[begin + static_cast<std::size_t>(u)];
    if (size >= config_.contrast_min * kParts && mean >= config_.steadiness * size) return true;
  }
  return false;
}

bool StillMask::is_still(int row, double left, double right) const {
  const int index = (row - first_row_ + config_.row_step / 2) / config_.row_step;
  if (row < first_row_ || index >= static_cast<int>(looks_.size())) return false;
  const auto i = static_cast<std::size_t>(index);
  return looks_[i] >= config_.looks && holds_edge(i, left, +1) && holds_edge(i, right, -1);
}

}  // namespace lanefuse
