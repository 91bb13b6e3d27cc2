// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/drive_key.hpp"

namespace lanefuse {

/// Which drives are asked for: a suite, and where it is not to be as it stands.
struct SuiteChoice {
  std::string suite = "nominal";       ///< nominal, scenes, ablations, road-ablations or coverage
  std::optional<std::string> road;     ///< gentle, curved or all
  std::optional<std::string> scene;    ///< only this one
  std::optional<std::string> variant;  ///< only this one, or all that there are of the estimator
  double noise = 1;                    ///< sensors err so many times as much as they say
  bool detections = false;             ///< each drive once more, on raw detections
  std::vector<std::uint64_t> seeds{1};
  std::optional<double> km;             ///< of each drive
  std::vector<std::string> estimators;  ///< each drive once with each; the suite's own, where none is named
  std::string truth = "exact";
};

std::vector<std::string> suite_names();

/// The suite's drives, seed by seed, so that a run that is broken off leaves whole seeds. Throws a
/// configuration Error for a name that is none, for a variant of another estimator, and where nothing is left
/// to drive.
std::vector<DriveKey> drives_of(const SuiteChoice& choice);

/// "1-6,9" as numbers in that order. Throws a configuration Error where it is no such list, names a seed
/// twice or more than kMostSeeds.
std::vector<std::uint64_t> parse_seeds(const std::string& text);
inline constexpr std::size_t kMostSeeds = 10'000;

}  // namespace lanefuse
