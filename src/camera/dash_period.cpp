// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/dash_period.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "camera/ground_projection.hpp"

namespace lanefuse {
namespace {

constexpr double kWayStep = 0.1;      ///< [m]
constexpr double kColumnStep = 0.05;  ///< [m]
constexpr int kBarReach = 5;          ///< columns: paint is darker so far to either side
constexpr int kLeastContrast = 10;    ///< grey levels of paint over both sides
constexpr int kSpread = 4;            ///< columns that a line may wander within its lane

int brightness(const ImageView& image, const Eigen::Vector2d& pixel) {
  const int u = static_cast<int>(std::lround(pixel.x()));
  const int v = static_cast<int>(std::lround(pixel.y()));
  if (u < 0 || v < 0 || u >= image.width || v >= image.height) return -1;
  const std::uint8_t* at = image.row(v) + static_cast<std::ptrdiff_t>(u) * image.channels;
  return image.channels == 3 ? (at[0] + 2 * at[1] + at[2]) / 4 : at[0];
}

/// 1 where a row of brightness shows a narrow bright bar, a little to either side of it too.
std::vector<std::uint8_t> bars(const std::vector<int>& row) {
  const int columns = static_cast<int>(row.size());
  const auto at = [&row](int c) { return row[static_cast<std::size_t>(c)]; };
  std::vector<std::uint8_t> found(row.size());
  for (int c = kBarReach; c + kBarReach < columns; ++c) {
    const int left = at(c - kBarReach);
    const int right = at(c + kBarReach);
    if (left < 0 || right < 0 || at(c) < std::max(left, right) + kLeastContrast) continue;
    std::fill(found.begin() + std::max(0, c - kSpread), found.begin() + std::min(columns, c + kSpread + 1),
              std::uint8_t{1});
  }
  return found;
}

/// How much of the columns' paint comes again with one period.
struct Coherence {
  double power = 0;
  double weighted = 0;  ///< each column's power by the share of its variance that this is

  void add(double column_power, double column_mean) {
    const double variance = column_mean * (1 - column_mean);
    if (!(variance > 0)) return;
    power += column_power;
    weighted += column_power * column_power / variance;
  }
  [[nodiscard]] double mean() const { return power > 0 ? weighted / power : 0; }
};

}  // namespace

DashPeriodMeter::DashPeriodMeter(const CameraIntrinsics& intrinsics, const DashPeriodConfig& config)
    : camera_(intrinsics),
      config_(config),
      columns_(static_cast<int>(2 * config.half_width / kColumnStep) + 1) {}

void DashPeriodMeter::add(const ImageView& image, const CameraPose& pose, double way) {
  const GroundProjection projection(camera_, pose);
  const auto first_seen = static_cast<std::int64_t>(std::ceil((way + config_.ahead) / kWayStep));
  if (!first_) first_ = first_seen;
  // All the road up to a little further than the nearest place: what the next image no longer shows.
  constexpr std::int64_t kStepsAhead = 40;
  const std::int64_t known = *first_ + static_cast<std::int64_t>(paint_.size()) / columns_;
  for (std::int64_t step = std::max(known, first_seen); step < first_seen + kStepsAhead; ++step) {
    const double x = pose.mounting.x + static_cast<double>(step) * kWayStep - way;
    std::vector<int> row(static_cast<std::size_t>(columns_), -1);
    for (int c = 0; c < columns_; ++c) {
      const auto pixel = projection.pixel({x, pose.mounting.y + (c * kColumnStep - config_.half_width)});
      if (pixel) row[static_cast<std::size_t>(c)] = brightness(image, *pixel);
    }
    const std::vector<std::uint8_t> found = bars(row);
    // A gap in the way (the first image after a break) is filled with nothing.
    paint_.resize(static_cast<std::size_t>((step - *first_) * columns_), 0);
    paint_.insert(paint_.end(), found.begin(), found.end());
  }
}

/// The strongest period of the paint between two steps, all columns' powers together.
std::optional<DashPeriodMeter::Peak> DashPeriodMeter::peak(std::size_t begin, std::size_t end) const {
  constexpr int kPeriods = 400;
  const auto columns = static_cast<std::size_t>(columns_);
  const auto count = static_cast<double>(end - begin);
  std::vector<double> means(columns);
  for (std::size_t s = begin; s < end; ++s) {
    for (std::size_t c = 0; c < columns; ++c) means[c] += paint_[s * columns + c] / count;
  }
  const double shortest = config_.expected * (1 - config_.tolerance);
  const double step = 2 * config_.tolerance * config_.expected / kPeriods;
  std::vector<double> powers;
  std::vector<double> coherences;
  for (int i = 0; i <= kPeriods; ++i) {
    const double turn = 2 * std::numbers::pi * kWayStep / (shortest + i * step);
    std::vector<std::complex<double>> sums(columns);
    for (std::size_t s = begin; s < end; ++s) {
      const std::complex<double> phase = std::polar(1.0, turn * static_cast<double>(s));
      for (std::size_t c = 0; c < columns; ++c) sums[c] += (paint_[s * columns + c] - means[c]) * phase;
    }
    // Columns count by how much of them comes again: most show no dashes, or solid lines.
    Coherence all;
    for (std::size_t c = 0; c < columns; ++c) all.add(std::norm(sums[c]) / (count * count), means[c]);
    powers.push_back(all.weighted);
    coherences.push_back(all.mean());
  }
  const auto best = std::max_element(powers.begin() + 1, powers.end() - 1);
  const double bend = best[-1] - 2 * best[0] + best[1];
  if (!(bend < 0)) return {};
  const double offset = 0.5 * (best[-1] - best[1]) / bend;
  const auto index = best - powers.begin();
  return Peak{shortest + step * (static_cast<double>(index) + offset),
              coherences[static_cast<std::size_t>(index)]};
}

std::optional<DashPeriod> DashPeriodMeter::measure() const {
  constexpr double kLeastPeriods = 4;
  constexpr double kLeastCoherence = 0.06;
  const std::size_t steps = paint_.size() / static_cast<std::size_t>(columns_);
  const double length = static_cast<double>(steps) * kWayStep;
  if (length < kLeastPeriods * config_.expected) return {};
  const auto whole = peak(0, steps);
  if (!whole || whole->coherence < kLeastCoherence) return {};
  // What a phase error of a twentieth of a period at both ends does; the halves' disagreement, if larger.
  DashPeriod result{.period = whole->period, .sigma = 0.1 * whole->period * whole->period / length};
  const auto first = peak(0, steps / 2);
  const auto second = peak(steps / 2, steps);
  if (first && second) {
    result.drift = second->period / first->period - 1;
    result.sigma = std::max(result.sigma, std::abs(result.drift) * whole->period / 4);
  }
  return result;
}

}  // namespace lanefuse
