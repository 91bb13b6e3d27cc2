// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/comma2k19_segment.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

namespace fs = std::filesystem;

constexpr int kLevelsBelow = 3;  ///< chunk / route / segment
constexpr std::size_t kNamedInError = 5;

bool is_segment(const fs::path& directory) {
  return fs::is_directory(directory / "processed_log") && fs::is_directory(directory / "global_pose");
}

void collect_segments(const fs::path& directory, int levels, std::vector<fs::path>& found) {
  if (is_segment(directory)) {
    found.push_back(directory);
  } else if (levels > 0) {
    for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
      if (entry.is_directory()) collect_segments(entry.path(), levels - 1, found);
    }
  }
}

std::vector<fs::path> segments_in(const fs::path& directory) {
  std::vector<fs::path> found;
  try {
    collect_segments(fs::canonical(directory), kLevelsBelow, found);
  } catch (const fs::filesystem_error& failure) {
    throw input_error(directory.string(), "cannot be read: " + failure.code().message());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::string Comma2k19Segment::name() const {
  return directory.parent_path().filename().string() + "/" + directory.filename().string();
}

Comma2k19Segment find_comma2k19_segment(const std::filesystem::path& directory) {
  const std::vector<fs::path> found = segments_in(directory);
  if (found.empty()) {
    throw input_error(directory.string(), "holds no comma2k19 segment",
                      "expected ROUTE/NUMBER with the folders processed_log and global_pose");
  }
  if (found.size() > 1) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(found.size(), kNamedInError); ++i) {
      names.push_back(Comma2k19Segment{found[i]}.name());
    }
    throw input_error(directory.string(), fmt::format("holds {} comma2k19 segments", found.size()),
                      fmt::format("name one of them: {}{}", fmt::join(names, ", "),
                                  found.size() > kNamedInError ? ", ..." : ""));
  }
  return {found.front()};
}

}  // namespace lanefuse
