// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/drive_statistics.hpp"

#include <cassert>
#include <cmath>
#include <limits>

#include "benchmark/student_t.hpp"

namespace lanefuse {
namespace {

constexpr double kConfidence = 0.95;

struct Moments {
  double mean = 0;
  double variance_of_mean = 0;
  double freedom = 0;  ///< 0: the variance is not known
};

Moments moments_of(std::span<const double> values) {
  assert(!values.empty());
  const auto n = static_cast<double>(values.size());
  Moments moments;
  for (const double value : values) moments.mean += value / n;
  moments.freedom = n - 1;
  if (values.size() < 2) return moments;
  for (const double value : values) {
    const double deviation = value - moments.mean;
    moments.variance_of_mean += deviation * deviation / (n * (n - 1));
  }
  return moments;
}

/// Sums of weighted values and of weights.
void add(const DriveSample& sample, DriveSample& sums) {
  assert(sample.weight > 0);
  sums.value += sample.weight * sample.value;
  sums.weight += sample.weight;
}

double mean_of(const DriveSample& sums) { return sums.value / sums.weight; }

/// By how much of itself the mean would be off if this drive alone spoke as it does.
double lean_of(const DriveSample& sample, const DriveSample& sums) {
  return sample.weight * (sample.value - mean_of(sums)) / sums.value;
}

Difference difference_of(const Moments& moments) {
  if (moments.freedom <= 0) return {moments.mean, {}, {}};
  const double sigma = std::sqrt(moments.variance_of_mean);
  // Values that are all the same leave no doubt: at zero there is no difference, elsewhere it is certain.
  double t = std::numeric_limits<double>::infinity();
  if (moments.mean == 0) t = 0;
  if (sigma > 0) t = moments.mean / sigma;
  return {moments.mean, two_sided_quantile(kConfidence, moments.freedom) * sigma,
          two_sided_probability(t, moments.freedom)};
}

}  // namespace

std::optional<MeanOfDrives> mean_of_drives(std::span<const DriveSample> samples) {
  if (samples.empty()) return std::nullopt;
  const auto n = static_cast<double>(samples.size());
  double total = 0;
  double weights = 0;
  for (const DriveSample& sample : samples) {
    assert(sample.weight > 0);
    total += sample.weight * sample.value;
    weights += sample.weight;
  }
  MeanOfDrives result{total / weights, {}, samples.size()};
  if (samples.size() < 2) return result;
  double squares = 0;
  for (const DriveSample& sample : samples) {
    const double deviation = sample.weight * (sample.value - result.mean);
    squares += deviation * deviation;
  }
  result.half_width = two_sided_quantile(kConfidence, n - 1) * std::sqrt(squares * n / (n - 1)) / weights;
  return result;
}

std::optional<RatioOfMeans> ratio_of_means(std::span<const PairedSample> samples) {
  const auto n = static_cast<double>(samples.size());
  DriveSample over{0, 0};
  DriveSample under{0, 0};
  for (const PairedSample& sample : samples) {
    add(sample.over, over);
    add(sample.under, under);
  }
  if (!(over.value > 0) || !(under.value > 0)) return std::nullopt;
  RatioOfMeans result{mean_of(over) / mean_of(under), {}};
  if (samples.size() < 2) return result;
  double squares = 0;
  for (const PairedSample& sample : samples) {
    const double lean = lean_of(sample.over, over) - lean_of(sample.under, under);
    squares += lean * lean;
  }
  result.factor = std::exp(two_sided_quantile(kConfidence, n - 1) * std::sqrt(squares * n / (n - 1)));
  return result;
}

Difference paired_difference(std::span<const double> differences) {
  return difference_of(moments_of(differences));
}

Difference unpaired_difference(std::span<const double> a, std::span<const double> b) {
  const Moments in_a = moments_of(a);
  const Moments in_b = moments_of(b);
  Moments both{in_b.mean - in_a.mean, in_a.variance_of_mean + in_b.variance_of_mean, 0};
  if (in_a.freedom <= 0 || in_b.freedom <= 0) return difference_of(both);
  both.freedom = in_a.freedom + in_b.freedom;
  if (both.variance_of_mean > 0) {
    both.freedom = both.variance_of_mean * both.variance_of_mean /
                   (in_a.variance_of_mean * in_a.variance_of_mean / in_a.freedom +
                    in_b.variance_of_mean * in_b.variance_of_mean / in_b.freedom);
  }
  return difference_of(both);
}

}  // namespace lanefuse
