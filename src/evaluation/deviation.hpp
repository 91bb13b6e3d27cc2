// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evaluation/magnitude_histogram.hpp"

namespace lanefuse {

/// Lanes are judged at 0, 10 ... 120 m ahead [IROS16, sec. III].
inline constexpr std::size_t kDistanceCount = 13;
constexpr double distance_at(std::size_t index) { return 10.0 * static_cast<double>(index); }

/// What is said of all deviations at one distance. A deviation is estimate minus truth, positive to the left,
/// measured across the truth line.
struct DeviationStatistics {
  double distance_m = 0;
  double mean_m = 0;   ///< NaN where n is 0, as are all the figures down to p95_m
  double sigma_m = 0;  ///< of this sample (divided by n), so that rmse^2 = mean^2 + sigma^2
  double rmse_m = 0;
  double p95_m = 0;  ///< of the magnitude
  double availability =
      0;  ///< share of the occasions with truth in which the estimate reached; NaN where none had truth
  std::uint64_t n = 0;  ///< deviations
};

/// Deviations at one distance, gathered in a stream (Welford): the memory does not grow with their number.
class DeviationAccumulator {
 public:
  /// One occasion on which truth existed; nothing where the estimate did not reach it. Deviations are finite.
  void add(std::optional<double> deviation);
  /// As if all that `other` was told had been told here.
  void merge(const DeviationAccumulator& other);
  [[nodiscard]] DeviationStatistics statistics(double distance) const;

 private:
  std::uint64_t occasions_ = 0;
  std::uint64_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;  // sum of the squared differences from the mean
  MagnitudeHistogram magnitudes_;
};

/// Deviations at every distance.
class DeviationByDistance {
 public:
  void add(std::size_t distance_index, std::optional<double> deviation) {
    at_[distance_index].add(deviation);
  }
  void merge(const DeviationByDistance& other);
  /// One entry a distance, in order.
  [[nodiscard]] std::vector<DeviationStatistics> statistics() const;

 private:
  std::array<DeviationAccumulator, kDistanceCount> at_;
};

}  // namespace lanefuse
