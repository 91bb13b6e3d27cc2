// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/figure.hpp"
#include "benchmark/result_line.hpp"

namespace lanefuse {

/// How many times another estimator's RMSE an estimator's is, over the drives that both of them drove.
struct EstimatorRatio {
  std::string to;          ///< the other estimator
  std::size_t drives = 0;  ///< that both drove
  /// By rmse_figure(): nothing where either has none.
  std::vector<std::optional<FigureMean>> rmse;
};

/// Finds the same drives of other estimators. The lines must outlive it.
class EstimatorRatios {
 public:
  explicit EstimatorRatios(std::span<const ResultLine> lines);

  /// The ratios of drives of one estimator, where the others have driven any of the same: of every estimator
  /// to the oracle, which says how far it is from what the data permits, and of the road-level one to the
  /// paper's graph.
  [[nodiscard]] std::vector<EstimatorRatio> of(std::span<const ResultLine* const> drives) const;

 private:
  std::map<DriveKey, const ResultLine*> by_key_;
};

}  // namespace lanefuse
