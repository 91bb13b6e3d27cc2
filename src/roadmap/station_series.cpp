// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/station_series.hpp"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace lanefuse {
namespace {

constexpr std::size_t kLeastForParabola = 5;

struct Window {
  std::size_t begin;
  std::size_t end;
};

Window window_around(std::size_t i, std::size_t reach, std::size_t size) {
  return {i > reach ? i - reach : 0, std::min(i + reach + 1, size)};
}

double parabola_at(const StationSeries& series, std::size_t middle, std::size_t reach) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const Window window = window_around(middle, reach, series.size());
  std::size_t count = 0;
  for (std::size_t i = window.begin; i < window.end; ++i) {
    if (!is_known(series[i])) continue;
    const double x = (static_cast<double>(i) - static_cast<double>(middle)) / static_cast<double>(reach);
    const Eigen::Vector3d row(1, x, x * x);
    normal += row * row.transpose();
    right += row * series[i];
    ++count;
  }
  if (count < kLeastForParabola) return kUnknown;
  return normal.ldlt().solve(right)[0];
}

}  // namespace

StationSeries box_mean(const StationSeries& series, std::size_t reach) {
  std::vector<double> sums(series.size() + 1, 0);
  std::vector<double> counts(series.size() + 1, 0);
  for (std::size_t i = 0; i < series.size(); ++i) {
    sums[i + 1] = sums[i] + (is_known(series[i]) ? series[i] : 0);
    counts[i + 1] = counts[i] + (is_known(series[i]) ? 1 : 0);
  }
  StationSeries means(series.size(), kUnknown);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const auto [begin, end] = window_around(i, reach, series.size());
    const double count = counts[end] - counts[begin];
    if (count > 0) means[i] = (sums[end] - sums[begin]) / count;
  }
  return means;
}

StationSeries smoothed(const StationSeries& series, std::size_t reach) {
  StationSeries result(series.size(), kUnknown);
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (is_known(series[i])) result[i] = reach > 0 ? parabola_at(series, i, reach) : series[i];
  }
  return result;
}

void fill_gaps(StationSeries& series, std::size_t longest) {
  std::size_t last = series.size();
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!is_known(series[i])) continue;
    const std::size_t unknown = last < i ? i - last - 1 : 0;
    for (std::size_t gap = 1; unknown <= longest && gap <= unknown; ++gap) {
      const double share = static_cast<double>(gap) / static_cast<double>(unknown + 1);
      series[last + gap] = series[last] + share * (series[i] - series[last]);
    }
    last = i;
  }
}

double mean_of(const StationSeries& series) {
  return mean_difference(series, StationSeries(series.size(), 0)).mean;
}

MeanDifference mean_difference(const StationSeries& a, const StationSeries& b) {
  MeanDifference difference;
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!is_known(a[i]) || !is_known(b[i])) continue;
    sum += a[i] - b[i];
    ++difference.count;
  }
  if (difference.count > 0) difference.mean = sum / static_cast<double>(difference.count);
  return difference;
}

double robust_mean(std::vector<double>& values, double inlier) {
  if (values.empty()) return kUnknown;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  double sum = 0;
  double weights = 0;
  for (const double value : values) {
    const double weight = values.size() < 3 ? 1 : inlier / std::max(inlier, std::abs(value - median));
    sum += weight * value;
    weights += weight;
  }
  return sum / weights;
}

}  // namespace lanefuse
