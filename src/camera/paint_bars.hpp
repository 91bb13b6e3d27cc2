// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "camera/image.hpp"

namespace lanefuse {

/// A bright bar in a piece of one image row.
struct PaintBar {
  double left = 0;      ///< [px] column of its left edge
  double right = 0;     ///< [px] column of its right edge
  double contrast = 0;  ///< [grey levels] against the darker side's neighbour of the two
  bool yellow = false;
};

/// Where in a row to look, and for how wide a bar.
struct BarQuery {
  int row = 0;
  int left = 0;          ///< first column
  int right = 0;         ///< last column
  double narrowest = 1;  ///< [px]
  double widest = 10;    ///< [px]
  /// [grey levels] least step at both edges on a road with usual grain; 0.6 of it where the image is smooth,
  /// up to double where it is noisy.
  double contrast = 7;
};

/// Finds bars in pieces of image rows by pairing a rise with the fall behind it, sub-pixel, in grey levels
/// and in yellowness, min(red, green) - blue, which shows yellow paint on concrete that is as bright as
/// itself.
///
/// Holds its own working memory: no allocation.
class PaintBarFinder {
 public:
  static constexpr int kLongest = 2560;     ///< [px] of a piece; longer ones are cut off at their right end
  static constexpr std::size_t kMost = 32;  ///< bars a piece

  /// In order of their left edges. Valid until the next call.
  std::span<const PaintBar> find(const ImageView& image, const BarQuery& query);

 private:
  static constexpr int kMargin = 8;  ///< [px] beyond both ends that edge filters reach
  using Sums = std::array<int, kLongest + 2 * kMargin + 1>;

  Sums grey_{};
  Sums yellow_{};
  std::array<PaintBar, kMost> bars_{};
  std::array<PaintBar, kMost> yellow_bars_{};

  void read(const ImageView& image, int row, int begin, int end);
  void mark_yellow(std::size_t& count, std::size_t yellow_count);
};

}  // namespace lanefuse
