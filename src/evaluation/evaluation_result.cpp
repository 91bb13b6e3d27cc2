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

}  // namespace lanefuse
