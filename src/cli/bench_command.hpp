// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace lanefuse {

/// `lanefuse bench lane-graphs DIR` and `lanefuse bench windows DIR`.
struct BenchOptions {
  std::filesystem::path folder;     ///< of .g2o files
  std::string solver = "lanefuse";  ///< what is measured against Ceres
  double seconds = 4;               ///< lane-graphs: how long a graph is repeated
  bool sub_windows = false;         ///< lane-graphs: each graph's quarters, too
  bool json = false;
  bool force = false;
};

/// Each graph of a folder, warm-started two iterations a cycle, with one of our solvers and with the best
/// setting of Ceres: docs/benchmark-graphs.md says what exactly is timed.
int bench_lane_graphs(const BenchOptions& options);

/// The windows of a drive (`run --dump-graphs`), in the order of their numbers, each from its own start.
int bench_windows(const BenchOptions& options);

}  // namespace lanefuse
