// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lanefuse {

/// `lanefuse run DRIVE`: fuses a recorded drive to lanes.
struct RunOptions {
  std::filesystem::path drive;
  std::filesystem::path output;
  std::optional<std::filesystem::path> config;
  std::optional<std::string> estimator;  ///< "graph" or "road", over the configuration
  std::optional<std::filesystem::path>
      graph_folder;                      ///< where each cycle's graph goes, as numbered .g2o files
  std::string solver = "lanefuse";       ///< of the graph, for comparison: see make_solver()
  std::vector<std::string> assignments;  ///< "key=value", over the file
  bool print_config = false;             ///< print the whole configuration instead of running
  bool json = false;
  bool force = false;
};

/// Throws Error (input) at the end of a drive that was damaged, after all that could be saved of it was
/// fused.
int run(const RunOptions& options);

}  // namespace lanefuse
