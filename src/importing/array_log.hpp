// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "importing/npy.hpp"

namespace lanefuse {

/// A log kept as parallel NumPy arrays: one of time stamps in seconds, and one or more of values, a row a
/// stamp.
struct ArrayLogFiles {
  struct Values {
    std::filesystem::path file;
    std::size_t columns = 1;              ///< what the file must have
    std::vector<std::size_t> kept = {0};  ///< the columns of interest, in which numbers must be finite
  };
  std::filesystem::path times;
  std::vector<Values> values;
};

/// What is believable of a log: stamps that do not run back, and beside them the kept columns of all value
/// files.
struct ArrayLog {
  std::vector<Time> times;
  NpyTable values;
};

/// Reads a log. Rows that are not finite or run back in time are left out and counted in a note, as long as
/// they are at most one in twenty. Throws Error naming file and row if there are more, and naming both files
/// if lengths differ.
ArrayLog read_array_log(const ArrayLogFiles& files, std::vector<std::string>& notes);

}  // namespace lanefuse
