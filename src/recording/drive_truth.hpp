// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "recording/read_report.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// The truth that a drive's recording holds beside its measurements: for whoever evaluates.
struct DriveTruth {
  std::optional<TrueRoad> road;
  std::vector<TrueFrame> frames;  ///< in order of time
  ReadReport report;
};

/// Empty where the recording holds none. Throws Error (input) where it is no recorded drive that this version
/// knows.
DriveTruth read_truth(const std::filesystem::path& path);

/// Copies a recording without what lies below /truth/: its measurements read back the same. `out` must be
/// another file. Throws Error (input) where `in` cannot be read or is damaged, and where `out` cannot be
/// written.
void strip_truth(const std::filesystem::path& in, const std::filesystem::path& out);

}  // namespace lanefuse
