// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/consistency.hpp"

#include <limits>

namespace lanefuse {

void ConsistencyByDistance::add(std::size_t distance_index, double deviation, double sigma) {
  if (!(sigma > 0)) return;
  at_[distance_index].squares += deviation * deviation / (sigma * sigma);
  ++at_[distance_index].count;
}

void ConsistencyByDistance::merge(const ConsistencyByDistance& other) {
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    at_[i].squares += other.at_[i].squares;
    at_[i].count += other.at_[i].count;
  }
}

std::vector<ConsistencyStatistics> ConsistencyByDistance::statistics() const {
  std::vector<ConsistencyStatistics> result;
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    const Sum& sum = at_[i];
    const double mean = sum.count == 0 ? std::numeric_limits<double>::quiet_NaN()
                                       : sum.squares / static_cast<double>(sum.count);
    result.push_back({distance_at(i), mean, sum.count});
  }
  return result;
}

}  // namespace lanefuse
