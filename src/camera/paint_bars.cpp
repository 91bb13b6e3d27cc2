// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/paint_bars.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

/// A row's piece as running sums: sums[i] is the sum of the pixels before the i-th of the piece.
struct Piece {
  const int* sums;
  int length;  ///< pixels
  int reach;   ///< pixels on each side of an edge that are averaged

  /// The step at the border before pixel i: the mean of `reach` pixels to its right minus the mean to its
  /// left.
  [[nodiscard]] double step(int i) const {
    return static_cast<double>(sums[i + reach] - 2 * sums[i] + sums[i - reach]) / reach;
  }
  [[nodiscard]] int first() const { return reach; }
  [[nodiscard]] int last() const { return length - reach; }
};

/// Whether the step at i is the largest of its neighbours in the direction `sign`.
bool is_peak(const Piece& piece, int i, double step, int sign) {
  return i > piece.first() && i < piece.last() && step >= sign * piece.step(i - 1) &&
         step > sign * piece.step(i + 1);
}

/// The border's place around i as the middle of all that rises (or falls) there, exact for a pixel that is
/// covered in part [px, from the piece's first pixel's middle].
double refined(const Piece& piece, int i, int sign) {
  double sum = 0;
  double moment = 0;
  const int reach = std::max(piece.reach, 2);
  for (int j = std::max(1, i - reach); j <= std::min(piece.length - 1, i + reach); ++j) {
    const int change = sign * (piece.sums[j + 1] - 2 * piece.sums[j] + piece.sums[j - 1]);
    if (change <= 0) continue;
    sum += change;
    moment += change * (j - i);
  }
  return sum > 0 ? i + moment / sum - 0.5 : i - 0.5;
}

/// The least step that stands out of the piece's grain.
double least_step(const Piece& piece, double usual) {
  constexpr int kEdge = 12;  // a larger change is no grain
  int sum = 0;
  for (int i = 1; i + 1 < piece.length; ++i) {
    const int bend = piece.sums[i + 2] - 3 * piece.sums[i + 1] + 3 * piece.sums[i] - piece.sums[i - 1];
    sum += std::min(std::abs(bend), kEdge);
  }
  // Of white noise the second difference has sqrt(6) sigma, and the mean size of a normal number is 0.8
  // sigma.
  const double sigma = static_cast<double>(sum) / (piece.length - 2) / (0.8 * std::sqrt(6.0));
  constexpr double kStandsOut = 4;  // [sigma]
  return std::clamp(kStandsOut * sigma * std::sqrt(2.0 / piece.reach), 0.6 * usual, 2 * usual);
}

struct Widths {
  double narrowest;
  double widest;
};

/// Pairs rises with the best fall behind each.
std::size_t pair_edges(const Piece& piece, const Widths& widths, double usual_contrast,
                       std::array<PaintBar, PaintBarFinder::kMost>& bars) {
  const double contrast = least_step(piece, usual_contrast);
  std::size_t count = 0;
  for (int i = piece.first() + 1; i < piece.last(); ++i) {
    const double rise = piece.step(i);
    if (rise < contrast || !is_peak(piece, i, rise, 1)) continue;
    int best = 0;
    double best_fall = 0;
    const int end = std::min(piece.last() - 1, i + static_cast<int>(std::ceil(widths.widest)));
    for (int j = i + std::max(1, static_cast<int>(widths.narrowest)); j <= end; ++j) {
      const double fall = -piece.step(j);
      // Another rise as high starts another bar.
      if (-fall > rise) break;
      if (fall > best_fall && fall >= contrast && is_peak(piece, j, fall, -1)) {
        best_fall = fall;
        best = j;
      }
    }
    if (best == 0) continue;
    const double left = refined(piece, i, 1);
    const double right = refined(piece, best, -1);
    if (right - left < widths.narrowest || right - left > widths.widest) continue;
    bars[count++] = {left, right, std::min(rise, best_fall), false};
    if (count == bars.size()) break;
  }
  return count;
}

}  // namespace

void PaintBarFinder::read(const ImageView& image, int row, int begin, int end) {
  const std::uint8_t* pixel = image.row(row) + static_cast<std::ptrdiff_t>(begin) * image.channels;
  int grey = 0;
  int yellow = 0;
  grey_[0] = yellow_[0] = 0;
  for (int i = 0; i < end - begin; ++i, pixel += image.channels) {
    if (image.channels == 3) {
      const int blue = pixel[0];
      const int green = pixel[1];
      const int red = pixel[2];
      grey += (blue + 2 * green + red + 2) / 4;
      yellow += std::max(0, std::min(red, green) - blue);
    } else {
      grey += pixel[0];
    }
    grey_[i + 1] = grey;
    yellow_[i + 1] = yellow;
  }
}

std::span<const PaintBar> PaintBarFinder::find(const ImageView& image, const BarQuery& query) {
  if (query.row < 0 || query.row >= image.height) return {};
  const int reach = std::clamp(static_cast<int>(std::lround(0.5 * query.narrowest)), 1, 5);
  const int begin = std::max(0, query.left - kMargin);
  const int end = std::min({image.width, query.right + 1 + kMargin, begin + kLongest + 2 * kMargin});
  if (end - begin < 2 * reach + 3) return {};
  read(image, query.row, begin, end);
  const Widths widths{query.narrowest, query.widest};
  std::size_t count = pair_edges({grey_.data(), end - begin, reach}, widths, query.contrast, bars_);
  if (image.channels == 3) {
    // Colour is stored at half the resolution by almost every codec: yellow bars are a little wider.
    const std::size_t yellow_count =
        pair_edges({yellow_.data(), end - begin, std::max(reach, 2)}, {query.narrowest, query.widest + 2},
                   query.contrast, yellow_bars_);
    mark_yellow(count, yellow_count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    bars_[i].left += begin;
    bars_[i].right += begin;
  }
  return {bars_.data(), count};
}

void PaintBarFinder::mark_yellow(std::size_t& count, std::size_t yellow_count) {
  const std::size_t grey_count = count;
  for (std::size_t k = 0; k < yellow_count; ++k) {
    const PaintBar& yellow = yellow_bars_[k];
    bool known = false;
    for (std::size_t i = 0; i < grey_count; ++i) {
      const double overlap = std::min(bars_[i].right, yellow.right) - std::max(bars_[i].left, yellow.left);
      if (overlap < 0.5 * std::min(bars_[i].right - bars_[i].left, yellow.right - yellow.left)) continue;
      // What is bright beside the paint, or dark on it, widens or narrows the bar of grey; colour tells.
      constexpr double kAlike = 0.35;
      const double width = yellow.right - yellow.left;
      if (std::abs(bars_[i].right - bars_[i].left - width) > kAlike * width) {
        bars_[i].left = yellow.left;
        bars_[i].right = yellow.right;
      }
      bars_[i].yellow = known = true;
    }
    if (known || count == bars_.size()) continue;
    bars_[count] = yellow;
    bars_[count++].yellow = true;
  }
  std::sort(bars_.begin(), bars_.begin() + static_cast<std::ptrdiff_t>(count),
            [](const PaintBar& a, const PaintBar& b) { return a.left < b.left; });
}

}  // namespace lanefuse
