// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/image_labels.hpp"

namespace lanefuse {

/// `lanefuse benchmark labels DRIVE`: fuses a drive recorded with images and compares lanes and vehicles with
/// what people marked in some of the images.
struct LabelBenchmarkOptions {
  std::filesystem::path drive;
  std::filesystem::path labels;
  std::string clip;  ///< whose labels they are; empty: the drive's name
  std::optional<std::filesystem::path> config;
  std::vector<std::string> assignments;  ///< "key=value", over the file
  LabelTolerance tolerance;
  bool list = false;  ///< say for every labelled image how far off the lanes are
  bool json = false;
  bool force = false;
};

int benchmark_labels(const LabelBenchmarkOptions& options);

}  // namespace lanefuse
