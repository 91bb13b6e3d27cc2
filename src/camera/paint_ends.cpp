// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/paint_ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kSigmaInside = 0.03;      ///< [rows] of paint that fills its row
constexpr double kSigmaAlone = 0.45;       ///< [sigma of a row's view] of a bar without a chain
constexpr double kSigmaOfFill = 0.12;      ///< of the share of a row that is paint: paint varies
constexpr double kSigmaOfShortFill = 0.4;  ///< the same where the chain is too short to show a full row
constexpr double kSigmaOfShift = 0.25;     ///< share of the shift that may be wrong

constexpr double kLeastFill = 0.25;  ///< of a row: with less paint its place is a guess
constexpr double kShiftMost = 0.8;   ///< of the row's height
constexpr int kLong = 4;             ///< bars of a chain that surely has a full row
constexpr double kLineReach = 0.6;   ///< [m]

/// By how many sigma the middle of the upper `fill` of a normal distribution is shifted (Mills's ratio).
double shift_of(double fill) {
  constexpr std::array<double, 11> kShift = {2.4,   1.755, 1.400, 1.159, 0.966, 0.798,
                                             0.644, 0.497, 0.350, 0.195, 0};
  const double at = std::clamp(fill, 0.0, 1.0) * 10;
  const auto i = std::min(static_cast<std::size_t>(at), std::size_t{9});
  return kShift[i] + (at - static_cast<double>(i)) * (kShift[i + 1] - kShift[i]);
}

/// Sigma of what a row sees, along the column [px].
double view_of(const RoadBar& bar, double blur_px) {
  return std::sqrt(bar.row_height * bar.row_height / 12.0 + blur_px * blur_px);
}

/// Paint in a row: brightness times width on the ground [grey levels m].
double paint_of(const RoadBar& bar) { return bar.bar.area * std::abs(bar.per_pixel(1, 0)); }

void shift(RoadBar& bar, double rows) {
  bar.row += rows;
  bar.x += bar.per_pixel(0, 1) * rows;
  bar.y += bar.per_pixel(1, 1) * rows;
}

/// The paint of a full row of the chain: what its brighter bars have.
double brightest(const std::vector<RoadBar>& bars, const BarChain& chain) {
  double most = 0;
  double second = 0;
  for (int i = chain.first; i >= 0; i = bars[static_cast<std::size_t>(i)].next) {
    const double paint = paint_of(bars[static_cast<std::size_t>(i)]);
    second = std::max(second, std::min(most, paint));
    most = std::max(most, paint);
  }
  return chain.count >= kLong ? second : most;
}

/// The line that a chain belongs to, or nothing.
const ParallelLines::Line* line_of(const std::vector<RoadBar>& bars, const BarChain& chain,
                                   const ParallelLines& lines) {
  const RoadBar& bar = bars[static_cast<std::size_t>(chain.first)];
  return lines.nearest(lines.offset(bar.x, bar.y), kLineReach);
}

}  // namespace

void PaintEnds::learn(const std::vector<RoadBar>& bars, std::span<const BarChain> chains,
                      const ParallelLines& lines) {
  long_chains_.clear();
  for (const BarChain& chain : chains) {
    if (chain.count < kLong) continue;
    const ParallelLines::Line* line = line_of(bars, chain, lines);
    if (!line) continue;
    long_chains_.push_back({static_cast<std::size_t>(line - lines.lines().data()), brightest(bars, chain)});
  }
  std::sort(long_chains_.begin(), long_chains_.end(), [](const LinePaint& a, const LinePaint& b) {
    return a.line != b.line ? a.line < b.line : a.paint < b.paint;
  });
}

double PaintEnds::full_paint(const std::vector<RoadBar>& bars, const BarChain& chain,
                             const ParallelLines& lines) const {
  const double own = brightest(bars, chain);
  if (chain.count >= kLong) return own;
  const ParallelLines::Line* line = line_of(bars, chain, lines);
  if (!line) return own;
  const auto index = static_cast<std::size_t>(line - lines.lines().data());
  const auto begin = std::lower_bound(long_chains_.begin(), long_chains_.end(), index,
                                      [](const LinePaint& a, std::size_t b) { return a.line < b; });
  auto end = begin;
  while (end != long_chains_.end() && end->line == index) ++end;
  if (begin == end) return own;
  return std::max(own, begin[(end - begin) / 2].paint);
}

/// `direction`: +1 where the paint lies below the row's middle, in the image.
void PaintEnds::settle_bar(RoadBar& bar, double full, double direction, bool is_long) const {
  const double view = view_of(bar, blur_px_);
  const double fill = paint_of(bar) / full;
  const double sigmas = shift_of(fill);
  bar.faint = fill < kLeastFill;
  const double of_fill = is_long ? kSigmaOfFill : kSigmaOfShortFill;
  bar.row_sigma = view * std::hypot(of_fill, kSigmaOfShift * sigmas);
  // Not past the next row of the chain, which lies nearer to the middle of the paint.
  shift(bar, direction * std::min(view * sigmas, kShiftMost * bar.row_height));
}

void PaintEnds::settle(std::vector<RoadBar>& bars, std::span<const BarChain> chains,
                       const ParallelLines& lines) {
  learn(bars, chains, lines);
  for (RoadBar& bar : bars) bar.row_sigma = kSigmaInside;
  for (const BarChain& chain : chains) {
    RoadBar& first = bars[static_cast<std::size_t>(chain.first)];
    RoadBar& last = bars[static_cast<std::size_t>(chain.last)];
    if (chain.count == 1) {
      first.row_sigma = kSigmaAlone * view_of(first, blur_px_);
      continue;
    }
    const double full = full_paint(bars, chain, lines);
    RoadBar& second = bars[static_cast<std::size_t>(first.next)];
    RoadBar& before = bars[static_cast<std::size_t>(last.previous)];
    // The blur of an end reaches the next row, where that is the next of the image.
    const bool is_long = chain.count >= kLong;
    const bool second_too = is_long && first.row - second.row < 1.5;
    const bool before_too = is_long && before.row - last.row < 1.5;
    settle_bar(first, full, -1, is_long);
    settle_bar(last, full, +1, is_long);
    if (second_too) settle_bar(second, full, -1, is_long);
    if (before_too) settle_bar(before, full, +1, is_long);
  }
}

}  // namespace lanefuse
