// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/consistency.hpp"

#include <cmath>
#include <limits>

namespace lanefuse {
namespace {

// Half widths, in sigma, of the intervals that hold 68, 95 and 99 % of a normal distribution.
constexpr std::array kIntervals{0.99446, 1.95996, 2.57583};

double mean_of(double sum, std::uint64_t count) {
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
}

}  // namespace

void ConsistencyByDistance::add(std::size_t distance_index, double deviation, double sigma) {
  if (!(sigma > 0)) return;
  const double normalised = std::abs(deviation) / sigma;
  Sum& sum = at_[distance_index];
  sum.squares += normalised * normalised;
  sum.sigmas += sigma;
  ++sum.count;
  for (std::size_t i = 0; i < kIntervals.size(); ++i) {
    if (normalised <= kIntervals[i]) ++sum.within[i];
  }
}

void ConsistencyByDistance::add_protection(std::size_t distance_index, double deviation, double protection) {
  if (!(protection > 0)) return;
  Sum& sum = at_[distance_index];
  sum.protection += protection;
  ++sum.protected_count;
  if (std::abs(deviation) > protection) ++sum.misleading;
}

void ConsistencyByDistance::merge(const ConsistencyByDistance& other) {
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    Sum& sum = at_[i];
    const Sum& more = other.at_[i];
    sum.squares += more.squares;
    sum.sigmas += more.sigmas;
    sum.count += more.count;
    for (std::size_t k = 0; k < kIntervals.size(); ++k) sum.within[k] += more.within[k];
    sum.protection += more.protection;
    sum.protected_count += more.protected_count;
    sum.misleading += more.misleading;
  }
}

std::vector<ConsistencyStatistics> ConsistencyByDistance::statistics() const {
  std::vector<ConsistencyStatistics> result;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    const Sum& sum = at_[i];
    const auto inside = [&sum](std::size_t k) {
      return mean_of(static_cast<double>(sum.within[k]), sum.count);
    };
    result.push_back({.distance_m = distance_at(i),
                      .mean_normalised_square = mean_of(sum.squares, sum.count),
                      .n = sum.count,
                      .within_68 = inside(0),
                      .within_95 = inside(1),
                      .within_99 = inside(2),
                      .stated_sigma_m = mean_of(sum.sigmas, sum.count),
                      .protection_m = mean_of(sum.protection, sum.protected_count),
                      .misleading_rate = mean_of(static_cast<double>(sum.misleading), sum.protected_count),
                      .n_protected = sum.protected_count});
  }
  return result;
}

}  // namespace lanefuse
