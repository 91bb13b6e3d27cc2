// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/summary.hpp"

namespace lanefuse {

/// `lanefuse benchmark merge FILES -o RESULTS`.
struct MergeResultsOptions {
  std::vector<std::filesystem::path> files;
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

/// `lanefuse benchmark table FILES`: means over drives; `coverage FILES`: whether their uncertainty is
/// honest.
struct ResultsTableOptions {
  std::vector<std::filesystem::path> files;
  GroupBy by = GroupBy::drive_kind;
  bool markdown = false;
  bool json = false;
  bool force = false;
};

/// `lanefuse benchmark compare A B`.
struct CompareResultsOptions {
  std::filesystem::path a;
  std::filesystem::path b;
  std::optional<std::string> variant_a;  ///< only the drives of this variant
  std::optional<std::string> variant_b;
  std::optional<std::string> estimator_a;  ///< only the drives of this estimator
  std::optional<std::string> estimator_b;
  bool json = false;
  bool force = false;
};

int merge_results_files(const MergeResultsOptions& options);
int show_results_table(const ResultsTableOptions& options);
int show_coverage(const ResultsTableOptions& options);
int compare_results(const CompareResultsOptions& options);

}  // namespace lanefuse
