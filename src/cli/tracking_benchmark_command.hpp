// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace lanefuse {

/// `lanefuse benchmark tracking`: simulates drives and judges the tracks of the vehicles around.
struct TrackingBenchmarkOptions {
  std::string road = "gentle";
  std::string seeds = "1";
  double km = 24;               ///< of each seed
  std::optional<double> hours;  ///< of each seed, instead
  std::optional<int> guard_rail_mirrors;
  std::size_t jobs = 0;  ///< at a time; 0: one a core
  bool json = false;
  bool force = false;
};

int benchmark_tracking(const TrackingBenchmarkOptions& options);

}  // namespace lanefuse
