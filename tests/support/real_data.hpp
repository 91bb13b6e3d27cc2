// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>

namespace lanefuse::testing {

/// The folder of real data: LANEFUSE_DATA, else ../shared/data beside the source tree. It may be absent.
inline std::filesystem::path real_data(const std::filesystem::path& part) {
  const char* from_environment = std::getenv("LANEFUSE_DATA");
  const std::filesystem::path root =
      from_environment ? from_environment : std::filesystem::path(LANEFUSE_SOURCE_DIR) / "../shared/data";
  return root / part;
}

}  // namespace lanefuse::testing

/// Skips the test, and says so, where the real data is not there.
#define LANEFUSE_NEEDS_DATA(path)                                                                  \
  if (!std::filesystem::exists(path)) {                                                            \
    GTEST_SKIP() << "real data not found at " << (path) << "; set LANEFUSE_DATA to run this test"; \
  }
