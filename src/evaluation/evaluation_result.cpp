// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/evaluation_result.hpp"

#include <limits>

namespace lanefuse {
namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double wrong_lane_rate(const EvaluationResult& result) {
  return ratio(result.cycles_in_wrong_lane, result.cycles_with_ego_lane);
}

double false_boundaries_per_cycle(const EvaluationResult& result) {
  return ratio(result.false_boundaries, result.cycles_with_truth);
}

double false_lanes_per_cycle(const EvaluationResult& result) {
  return ratio(result.false_lanes, result.cycles_with_truth);
}

double mean_normalised_square(const LaneConsistency& consistency) {
  double sum = 0;
  std::uint64_t count = 0;
  for (const auto* lanes : {&consistency.ego, &consistency.adjacent}) {
    for (const ConsistencyStatistics& at : *lanes) {
      if (at.n == 0) continue;
      sum += at.mean_normalised_square * static_cast<double>(at.n);
      count += at.n;
    }
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
}

}  // namespace lanefuse
