// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/estimator_ratio.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "benchmark/estimator_choice.hpp"

namespace lanefuse {
namespace {

/// What drives of the estimator are measured against.
std::vector<std::string_view> measured_against(std::string_view estimator) {
  if (estimator == kOracle) return {};
  if (estimator == "road") return {kOracle, "graph"};
  return {kOracle};
}

using Pair = std::pair<const ResultLine*, const ResultLine*>;

EstimatorRatio ratio_over(std::span<const Pair> pairs, std::string_view to) {
  EstimatorRatio ratio{std::string(to), pairs.size(), {}};
  for (std::size_t i = 0; i < 2 * kShownDistances; ++i) {
    const BenchmarkFigure& figure = figures()[i];
    std::vector<PairedSample> samples;
    for (const auto& [ours, theirs] : pairs) {
      const auto numerator = sample_of(figure, ours->json);
      const auto denominator = sample_of(figure, theirs->json);
      if (numerator && denominator) samples.push_back({*numerator, *denominator});
    }
    const auto squares = ratio_of_means(samples);
    auto& mean = ratio.rmse.emplace_back();
    if (!squares) continue;
    mean = FigureMean{std::sqrt(squares->ratio), {}, {}, samples.size()};
    if (!squares->factor) continue;
    mean->low = mean->value / std::sqrt(*squares->factor);
    mean->high = mean->value * std::sqrt(*squares->factor);
  }
  return ratio;
}

}  // namespace

EstimatorRatios::EstimatorRatios(std::span<const ResultLine> lines) {
  for (const ResultLine& line : lines) by_key_.try_emplace(line.key, &line);
}

std::vector<EstimatorRatio> EstimatorRatios::of(std::span<const ResultLine* const> drives) const {
  std::vector<EstimatorRatio> ratios;
  for (const std::string_view to :
       measured_against(drives.empty() ? kOracle : drives.front()->key.estimator)) {
    std::vector<Pair> pairs;
    for (const ResultLine* drive : drives) {
      DriveKey other = drive->key;
      other.estimator = to;
      if (const auto found = by_key_.find(other); found != by_key_.end())
        pairs.emplace_back(drive, found->second);
    }
    if (!pairs.empty()) ratios.push_back(ratio_over(pairs, to));
  }
  return ratios;
}

}  // namespace lanefuse
