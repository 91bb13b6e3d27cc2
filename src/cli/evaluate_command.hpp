// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lanefuse {

/// `lanefuse evaluate LANES --truth exact|ego-path`: compares estimated lanes with the truth and writes a
/// report.
struct EvaluateOptions {
  std::filesystem::path lanes;
  std::string truth;
  std::optional<std::filesystem::path> drive;   ///< with the truth; else the one that the run names
  std::optional<std::filesystem::path> report;  ///< else report.html beside the lanes
  bool json = false;
  bool force = false;
};

int evaluate(const EvaluateOptions& options);

}  // namespace lanefuse
