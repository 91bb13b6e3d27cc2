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
constexpr double kNarrow = 16;          ///< [px] bars up to here are measured as a whole, wider ones by edges
constexpr double kPriorPixels = 8;      ///< that the row's noise counts for beside the flanks' own

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

void BarFinder::measure(const RowSignal& signal, int rising, int falling) {
  const int width = falling - rising;
  const int margin = std::min((width + 1) / 2, 6) + 1;  // what blur and slant take
  const int reach = std::clamp(width, 4, 24);
  const Side left = flank(signal, rising - margin - reach, rising - margin);
  const Side right = flank(signal, falling + margin, falling + margin + reach);
  if (left.count < 3 || right.count < 3) return;
  const int inner = std::min(width / 4, margin);
  const double inside =
      static_cast<double>(signal.sum(rising + inner, falling - inner)) / (width - 2 * inner);
  const double over_left = inside - left.level;
  const double over_right = inside - right.level;
  const double contrast = (over_left + over_right) / 2;
  const double least = config_.contrast_min * signal.rows();
  if (over_left < least || over_right < least) return;
  if (over_left > config_.most_uneven * over_right || over_right > config_.most_uneven * over_left) return;
  // Noise of a pixel as it acts on sums of some: the row's by its gradient, the place's by the flanks.
  const double of_row = gradient_noise_ * gradient_noise_ / (2 * step_);
  const int flanks = left.count + right.count - 2;
  const double variance =
      (kPriorPixels * of_row + (left.count - 1) * left.variance + (right.count - 1) * right.variance) /
      (kPriorPixels + flanks);
  const double noise = std::sqrt(variance);
  if (contrast * std::sqrt(static_cast<double>(width)) < config_.evidence_min * noise) return;

  RowBar bar;
  bar.contrast = contrast / signal.rows();
  bar.noise = noise / signal.rows();
  const int begin = rising - margin;
  const int end = falling + margin;
  const int middle = (rising + falling) / 2;
  if (width <= kNarrow) {
    double area = 0;
    double moment = 0;
    for (int u = begin; u < end; ++u) {
      const double over = signal.level(u) - (u < middle ? left.level : right.level);
      area += over;
      moment += over * (u - middle);
    }
    if (!(area > 0.5 * contrast * width)) return;
    bar.centre = middle + moment / area;
    const double half = std::clamp(area / contrast / 2, width / 4.0, 1.0 * width);
    bar.left = bar.centre - half;
    bar.right = bar.centre + half;
    const int count = end - begin;
    const double moments = count * count * count / 12.0;
    const double of_flanks = count * count * count * count / 64.0 * (1.0 / left.count + 1.0 / right.count);
    bar.sigma = noise * std::sqrt(moments + of_flanks) / area;
    bar.area = area / signal.rows();
  } else {
    const int reach_in = std::min(width / 2, margin + 12);
    const Side inner_left = flank(signal, rising + margin, rising + margin + std::max(3, width / 3));
    const Side inner_right = flank(signal, falling - margin - std::max(3, width / 3), falling - margin);
    const int stop = rising + std::min(reach_in, margin);
    const int start = falling - std::min(reach_in, margin);
    const double step_left = inner_left.level - left.level;
    const double step_right = inner_right.level - right.level;
    if (step_left < least || step_right < least) return;
    const double area_left = signal.sum(begin, stop) - (stop - begin) * left.level;
    const double area_right = signal.sum(start, end) - (end - start) * right.level;
    bar.left = stop - 0.5 - area_left / step_left;
    bar.right = start - 0.5 + area_right / step_right;
    bar.centre = (bar.left + bar.right) / 2;
    const double window = 2.0 * margin;
    const double edge = window + window * window / 4 * (1.0 / left.count + 1.0 / inner_left.count);
    bar.sigma = noise / contrast * std::sqrt(edge / 2);
    bar.area = bar.contrast * (bar.right - bar.left);
  }
  bars_.push_back(bar);
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
