// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/consistency.hpp"

#include <cmath>
#include <limits>

namespace lanefuse {
namespace {

// Half widths, in sigma, of the intervals that hold 68, 95 and 99 % of a normal distribution.
constexpr std::array kIntervals{0.99446, 1.95996, 2.57583};

}  // namespace

void ConsistencyByDistance::add(std::size_t distance_index, double deviation, double sigma) {
  if (!(sigma > 0)) return;
  const double normalised = std::abs(deviation) / sigma;
  Sum& sum = at_[distance_index];
  sum.squares += normalised * normalised;
  ++sum.count;
  for (std::size_t i = 0; i < kIntervals.size(); ++i) {
    if (normalised <= kIntervals[i]) ++sum.within[i];
  }
}

void ConsistencyByDistance::merge(const ConsistencyByDistance& other) {
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    at_[i].squares += other.at_[i].squares;
    at_[i].count += other.at_[i].count;
    for (std::size_t k = 0; k < kIntervals.size(); ++k) at_[i].within[k] += other.at_[i].within[k];
  }
}

std::vector<ConsistencyStatistics> ConsistencyByDistance::statistics() const {
  std::vector<ConsistencyStatistics> result;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    const Sum& sum = at_[i];
    const auto share = [&sum](double part) {
      return sum.count == 0 ? std::numeric_limits<double>::quiet_NaN()
                            : part / static_cast<double>(sum.count);
    };
    const auto inside = [&](std::size_t k) { return share(static_cast<double>(sum.within[k])); };
    result.push_back({distance_at(i), share(sum.squares), sum.count, inside(0), inside(1), inside(2)});
  }
  return result;
}

}  // namespace lanefuse
