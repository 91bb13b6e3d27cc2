// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/suite.hpp"

namespace lanefuse {

/// `lanefuse benchmark -o RESULTS`: simulates, fuses and judges many drives, one line of results each.
struct BenchmarkOptions {
  SuiteChoice choice;
  std::string seeds = "1-6";
  std::vector<std::string> assignments;  ///< "key=value", over the variant's configuration
  std::string slice;                     ///< "I/N": every N-th drive from the I-th on; empty for all
  std::size_t jobs = 0;                  ///< drives at a time; 0: one a core
  std::optional<std::filesystem::path> output;
  bool list = false;      ///< name the drives and stop
  bool no_times = false;  ///< leave out all that another run would measure otherwise
  bool json = false;
  bool force = false;
};

/// Drives whose line is in the output already are skipped; `force` starts it anew.
int benchmark(const BenchmarkOptions& options);

}  // namespace lanefuse
