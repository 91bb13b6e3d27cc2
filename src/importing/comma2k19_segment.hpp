// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace lanefuse {

/// One minute of the comma2k19 data set: ROUTE/NUMBER with processed_log and global_pose inside.
struct Comma2k19Segment {
  std::filesystem::path directory;

  [[nodiscard]] std::string name() const;  ///< "ROUTE/NUMBER", as the data set calls it
};

/// The segment at `directory`, or the only one below it. Throws Error if there is none or more than one.
Comma2k19Segment find_comma2k19_segment(const std::filesystem::path& directory);

}  // namespace lanefuse
