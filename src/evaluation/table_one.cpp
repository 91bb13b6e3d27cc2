// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/table_one.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

AgainstPaper judge(double ratio, double distance) {
  if (!std::isfinite(ratio)) return AgainstPaper::not_judged;
  const bool near = distance <= 80;
  if (ratio > (near ? 1.35 : 2.0)) return AgainstPaper::worse;
  return ratio < (near ? 0.65 : 0.5) ? AgainstPaper::better : AgainstPaper::alike;
}

PaperComparison against(const DeviationStatistics& ours, const PaperFigures& paper, bool ego) {
  const double ratio = ours.rmse_m / paper.rmse;
  return {ours.distance_m, ego, ours, paper, ratio, judge(ratio, ours.distance_m)};
}

}  // namespace

std::vector<PaperComparison> compare_with_table_one(const LaneStatistics& lanes) {
  std::vector<PaperComparison> result;
  const auto at = [](const std::vector<DeviationStatistics>& all, double distance) {
    return std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.distance_m == distance; });
  };
  for (const PaperRow& row : kTableOne) {
    const auto ego = at(lanes.ego, row.distance);
    const auto adjacent = at(lanes.adjacent, row.distance);
    if (ego != lanes.ego.end()) result.push_back(against(*ego, row.ego, true));
    if (adjacent != lanes.adjacent.end()) result.push_back(against(*adjacent, row.adjacent, false));
  }
  return result;
}

}  // namespace lanefuse
