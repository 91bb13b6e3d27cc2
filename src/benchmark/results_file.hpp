// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "benchmark/result_line.hpp"

namespace lanefuse {

/// A file of results: one line of JSON a drive.
struct ResultsFile {
  std::filesystem::path path;
  std::vector<ResultLine> lines;
  std::uintmax_t whole_bytes = 0;  ///< up to the end of the last whole line
  bool cut_off = false;            ///< a run was killed within the line that follows
};

/// Throws an input Error for a file that cannot be read, and for a whole line that is none of results. What
/// follows the last end of a line is passed over: see `cut_off`.
ResultsFile read_results(const std::filesystem::path& path);

/// All lines of all files, sorted by key; those that repeat another (but for wall-clock times) once. Throws
/// an input Error that names both places where two lines of one key contradict each other.
std::vector<ResultLine> merge_results(const std::vector<ResultsFile>& files);

/// Writes a file of results line by line, so that a run that is killed leaves whole lines and at most one
/// that is cut off.
class ResultsWriter {
 public:
  /// Goes on behind the first `kept_bytes` of the file; what follows them is removed. Throws an input Error
  /// where it cannot be written, as append() does.
  ResultsWriter(std::filesystem::path path, std::uintmax_t kept_bytes);

  void append(const std::string& line);

 private:
  std::filesystem::path path_;
  std::ofstream out_;
};

}  // namespace lanefuse
