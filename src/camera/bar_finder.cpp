// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/bar_finder.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kThinPaint = 0.15;     ///< [m] the width that the gradient's scale is made for
constexpr int kWidestStep = 8;          ///< [px]
constexpr double kMadToSigma = 1.4826;  ///< of a normal distribution
constexpr double kLeastEven = 0.35;     ///< the weaker edge of a bar over the stronger one
constexpr int kNarrow = 16;     ///< [px] bars up to here are measured as a whole, wider ones by their edges
constexpr int kWidestBlur = 6;  ///< [px] that blur and slant take of a bar's side, at most
constexpr double kPriorPixels = 8;  ///< that the row's noise counts for beside the flanks' own

}  // namespace

BarFinder::BarFinder(int width, const BarFinderConfig& config)
    : config_(config), gradient_(static_cast<std::size_t>(width) + 1) {}

void BarFinder::differentiate(const RowSignal& signal) {
  const std::int32_t* sums = signal.sums();
  std::int32_t* gradient = gradient_.data();
  const int step = step_;
  const int end = signal.end() - step;
  for (int u = signal.begin() + step; u <= end; ++u) {
    gradient[u] = sums[u + step] - 2 * sums[u] + sums[u - step];
  }
}

/// The median of the gradient's size around the car, where most is road: texture counts as noise.
void BarFinder::measure_noise(const RowSignal& signal, const PlannedRow& row) {
  constexpr int kStride = 3;
  histogram_.fill(0);
  const int begin = std::max(signal.begin() + step_, row.core_begin);
  const int end = std::min(signal.end() - step_, row.core_end);
  int count = 0;
  for (int u = begin; u < end; u += kStride, ++count) {
    const int size = std::min(std::abs(gradient_[static_cast<std::size_t>(u)]), 1023);
    ++histogram_[static_cast<std::size_t>(size)];
  }
  int below = 0;
  std::size_t bin = 0;
  while (bin < 1023 && 2 * (below + histogram_[bin]) < count) below += histogram_[bin++];
  const double within = histogram_[bin] > 0 ? (0.5 * count - below) / histogram_[bin] : 0;
  const double median = bin == 0 ? within / 2 : static_cast<double>(bin) - 0.5 + within;
  // Quantisation alone makes a third of a level.
  gradient_noise_ = std::hypot(kMadToSigma * median, 0.3 * std::sqrt(2.0 * step_ * signal.rows()));
}

void BarFinder::find_edges(const RowSignal& signal) {
  edges_.clear();
  const double least =
      std::max(config_.contrast_to_noise * gradient_noise_, config_.contrast_min * step_ * signal.rows());
  const auto threshold = static_cast<std::int32_t>(least);
  const std::int32_t* gradient = gradient_.data();
  const int end = signal.end() - step_;
  for (int u = signal.begin() + step_; u <= end; ++u) {
    if (std::abs(gradient[u]) <= threshold) continue;
    const bool rising = gradient[u] > 0;
    Edge edge{u, gradient[u]};
    for (; u <= end && (rising ? gradient[u] > threshold : gradient[u] < -threshold); ++u) {
      if (std::abs(gradient[u]) > std::abs(edge.strength)) edge = {u, gradient[u]};
    }
    edges_.push_back(edge);
    --u;
  }
}

/// The edge that ends the bar which begins at `rising`.
const BarFinder::Edge* BarFinder::partner(std::size_t rising, double narrowest, double widest) const {
  const Edge& first = edges_[rising];
  for (std::size_t i = rising + 1; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    if (edge.at - first.at > widest) return nullptr;
    if (edge.strength > first.strength) return nullptr;  // the bar begins only there
    if (edge.strength > 0 || -edge.strength < kLeastEven * first.strength) continue;
    if (first.strength < -kLeastEven * edge.strength) return nullptr;
    return edge.at - first.at >= narrowest ? &edge : nullptr;
  }
  return nullptr;
}

BarFinder::Side BarFinder::flank(const RowSignal& signal, int from, int to) const {
  Side side;
  from = std::max(from, signal.begin());
  to = std::min(to, signal.end());
  side.count = to - from;
  if (side.count < 2) return side;
  side.level = static_cast<double>(signal.sum(from, to)) / side.count;
  for (int u = from; u < to; ++u) {
    const double off = signal.level(u) - side.level;
    side.variance += off * off;
  }
  side.variance /= side.count - 1;
  return side;
}

/// Noise of a pixel as it acts on sums of some: the row's by its gradient, the place's by the flanks.
double BarFinder::noise_of(const Side& left, const Side& right) const {
  const double of_row = gradient_noise_ * gradient_noise_ / (2 * step_);
  const double of_flanks = (left.count - 1) * left.variance + (right.count - 1) * right.variance;
  return std::sqrt((kPriorPixels * of_row + of_flanks) / (kPriorPixels + left.count + right.count - 2));
}

/// A bar of few pixels: the centre of mass of what stands out.
bool BarFinder::measure_whole(const RowSignal& signal, const Place& place, RowBar& bar) const {
  const int width = place.falling - place.rising;
  const int begin = place.rising - place.margin;
  const int end = place.falling + place.margin;
  const int middle = (place.rising + place.falling) / 2;
  double area = 0;
  double moment = 0;
  for (int u = begin; u < end; ++u) {
    const double over = signal.level(u) - (u < middle ? place.left.level : place.right.level);
    area += over;
    moment += over * (u - middle);
  }
  if (!(area > 0.5 * place.contrast * width)) return false;
  bar.centre = middle + moment / area;
  const double half = std::clamp(area / place.contrast / 2, width / 4.0, 1.0 * width);
  bar.left = bar.centre - half;
  bar.right = bar.centre + half;
  bar.area = area / signal.rows();
  // Every pixel by its arm, and the flanks' levels by the first moment of half a window.
  const double count = end - begin;
  const double by_pixels = count * count * count / 12;
  const double by_flanks =
      count * count * count * count / 64 * (1.0 / place.left.count + 1.0 / place.right.count);
  bar.sigma = place.noise * std::sqrt(by_pixels + by_flanks) / area;
  return true;
}

/// A wide bar: each edge by itself, so that worn paint between them does not count.
bool BarFinder::measure_edges(const RowSignal& signal, const Place& place, RowBar& bar) const {
  const int width = place.falling - place.rising;
  const int reach = std::max(3, width / 3);
  const int begin = place.rising - place.margin;
  const int stop = place.rising + place.margin;
  const int start = place.falling - place.margin;
  const int end = place.falling + place.margin;
  const Side paint_left = flank(signal, stop, stop + reach);
  const Side paint_right = flank(signal, start - reach, start);
  const double step_left = paint_left.level - place.left.level;
  const double step_right = paint_right.level - place.right.level;
  const double least = config_.contrast_min * signal.rows();
  if (step_left < least || step_right < least) return false;
  bar.left = stop - 0.5 - (signal.sum(begin, stop) - (stop - begin) * place.left.level) / step_left;
  bar.right = start - 0.5 + (signal.sum(start, end) - (end - start) * place.right.level) / step_right;
  bar.centre = (bar.left + bar.right) / 2;
  bar.area = bar.contrast * (bar.right - bar.left);
  const double window = 2.0 * place.margin;
  const double by_levels = window * window / 4 * (1.0 / place.left.count + 1.0 / paint_left.count);
  bar.sigma = place.noise / place.contrast * std::sqrt((window + by_levels) / 2);
  return true;
}

void BarFinder::measure(const RowSignal& signal, int rising, int falling) {
  const int width = falling - rising;
  Place place{rising, falling, std::min((width + 1) / 2, kWidestBlur) + 1};
  const int reach = std::clamp(width, 4, 24);
  place.left = flank(signal, rising - place.margin - reach, rising - place.margin);
  place.right = flank(signal, falling + place.margin, falling + place.margin + reach);
  if (place.left.count < 3 || place.right.count < 3) return;
  const int inner = std::min(width / 4, place.margin);
  const double inside =
      static_cast<double>(signal.sum(rising + inner, falling - inner)) / (width - 2 * inner);
  const double over_left = inside - place.left.level;
  const double over_right = inside - place.right.level;
  const double least = config_.contrast_min * signal.rows();
  if (over_left < least || over_right < least) return;
  if (std::max(over_left, over_right) > config_.most_uneven * std::min(over_left, over_right)) return;
  place.contrast = (over_left + over_right) / 2;
  place.noise = noise_of(place.left, place.right);
  if (place.contrast * std::sqrt(static_cast<double>(width)) < config_.evidence_min * place.noise) return;
  RowBar bar;
  bar.contrast = place.contrast / signal.rows();
  bar.noise = place.noise / signal.rows();
  bar.road = (place.left.level + place.right.level) / 2 / signal.rows();
  const bool measured =
      width <= kNarrow ? measure_whole(signal, place, bar) : measure_edges(signal, place, bar);
  if (measured) bars_.push_back(bar);
}

const std::vector<RowBar>& BarFinder::find(const RowSignal& signal, const PlannedRow& row, double slant) {
  bars_.clear();
  step_ = std::clamp(static_cast<int>(std::lround(0.9 * kThinPaint * row.scale)), 2, kWidestStep);
  if (signal.end() - signal.begin() <= 4 * step_ || row.scale <= 0) return bars_;
  differentiate(signal);
  measure_noise(signal, row);
  find_edges(signal);
  const double narrowest = std::max(1.0, config_.width_min * (1 - config_.width_tolerance) * row.scale - 1);
  const double widest = config_.width_max * (1 + config_.width_tolerance) * row.scale + slant + 1;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].strength < 0) continue;
    const Edge* falling = partner(i, narrowest, widest);
    if (falling) measure(signal, edges_[i].at, falling->at);
  }
  return bars_;
}

}  // namespace lanefuse
