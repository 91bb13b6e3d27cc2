// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace lanefuse {

/// `lanefuse strip DRIVE`: copies a recorded drive without its truth.
struct StripOptions {
  std::filesystem::path drive;
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int strip(const StripOptions& options);

}  // namespace lanefuse
