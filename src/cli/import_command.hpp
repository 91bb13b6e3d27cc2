// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace lanefuse {

/// `lanefuse import comma2k19 DIR`: turns a recorded drive of a public data set into a recording.
struct ImportOptions {
  std::filesystem::path directory;
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int import_comma2k19_drive(const ImportOptions& options);

}  // namespace lanefuse
