// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lanefuse {

/// `lanefuse evaluate LANES --truth exact|surveyed|ego-path` or `--map MAP`: compares estimated lanes with
/// the truth and writes a report.
struct EvaluateOptions {
  std::filesystem::path lanes;
  std::string truth;                            ///< empty with a map
  std::uint64_t truth_seed = 1;                 ///< of the survey's errors
  std::optional<std::filesystem::path> map;     ///< in the frame of the drive's true poses
  bool serial_camera = false;                   ///< judge the serial camera alone beside the estimate
  std::optional<std::filesystem::path> drive;   ///< with the truth; else the one that the run names
  std::optional<std::filesystem::path> report;  ///< else report.html beside the lanes
  bool json = false;
  bool force = false;
};

int evaluate(const EvaluateOptions& options);

}  // namespace lanefuse
