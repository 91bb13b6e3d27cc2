// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/deviation.hpp"

#include <cassert>
#include <cmath>
#include <limits>

namespace lanefuse {

void DeviationAccumulator::add(std::optional<double> deviation) {
  ++occasions_;
  if (!deviation) return;
  assert(std::isfinite(*deviation));
  ++count_;
  const double from_old_mean = *deviation - mean_;
  mean_ += from_old_mean / static_cast<double>(count_);
  squares_ += from_old_mean * (*deviation - mean_);
  magnitudes_.add(std::abs(*deviation));
}

void DeviationAccumulator::merge(const DeviationAccumulator& other) {
  occasions_ += other.occasions_;
  if (other.count_ == 0) return;
  const double total = static_cast<double>(count_ + other.count_);
  const double share = static_cast<double>(other.count_) / total;
  const double difference = other.mean_ - mean_;
  mean_ += difference * share;
  squares_ += other.squares_ + difference * difference * share * static_cast<double>(count_);
  count_ += other.count_;
  magnitudes_.merge(other.magnitudes_);
}

DeviationStatistics DeviationAccumulator::statistics(double distance) const {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  DeviationStatistics result{distance, kNothing, kNothing, kNothing, kNothing, kNothing, count_};
  if (occasions_ > 0) result.availability = static_cast<double>(count_) / static_cast<double>(occasions_);
  if (count_ == 0) return result;
  result.mean_m = mean_;
  result.sigma_m = std::sqrt(squares_ / static_cast<double>(count_));
  result.rmse_m = std::hypot(result.mean_m, result.sigma_m);
  result.p95_m = magnitudes_.quantile(0.95);
  return result;
}

void DeviationByDistance::merge(const DeviationByDistance& other) {
  for (std::size_t i = 0; i < kDistanceCount; ++i) at_[i].merge(other.at_[i]);
}

std::vector<DeviationStatistics> DeviationByDistance::statistics() const {
  std::vector<DeviationStatistics> result;
  for (std::size_t i = 0; i < kDistanceCount; ++i) result.push_back(at_[i].statistics(distance_at(i)));
  return result;
}

}  // namespace lanefuse
