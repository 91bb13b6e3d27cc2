// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/estimator_ratio.hpp"
#include "benchmark/figure.hpp"
#include "benchmark/result_line.hpp"

namespace lanefuse {

/// What a table has a row for. Estimators, truths, lengths and noises never share one.
enum class GroupBy { drive_kind, variant, scene, road };

/// Drives that share a row; never none.
struct DriveGroup {
  std::string
      name;  ///< "nominal, gentle, full", or by one thing only: "full"; with ", noise x 2" where it is
  std::vector<const ResultLine*> lines;
};

/// Groups in the order in which their first line comes; the lines must outlive them. Throws as summarise().
std::vector<DriveGroup> group_drives(std::span<const ResultLine> lines, GroupBy by);

/// The drives of one row.
struct Summary {
  std::string name;      ///< of its group
  bool nominal = false;  ///< all its drives are of the nominal scene and the full system, as the paper's were
  std::string estimator;
  std::string truth;
  double km = 0;     ///< a drive
  double noise = 1;  ///< sensors err so many times as much as they say
  std::size_t drives = 0;
  std::vector<std::optional<FigureMean>> means;  ///< of figures(), in their order
  std::vector<EstimatorRatio> ratios = {};       ///< where other estimators have driven the same
};

/// Rows in the order in which their first line comes. Throws an input Error where drives come from different
/// presets, those of one scene from different scenarios, or those of one variant and estimator from different
/// configurations or versions: such a mean says nothing.
std::vector<Summary> summarise(std::span<const ResultLine> lines, GroupBy by);

}  // namespace lanefuse
