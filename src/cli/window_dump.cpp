// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/window_dump.hpp"

#include <fstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "graph/g2o.hpp"
#include "graph/window_conversion.hpp"

namespace lanefuse {

WindowDump::WindowDump(std::filesystem::path folder, bool force) : folder_(std::move(folder)) {
  std::error_code failed;
  std::filesystem::create_directories(folder_, failed);
  if (failed) throw configuration_error(folder_.string(), "cannot be made as a folder");
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == ".g2o") old.push_back(entry.path());
  }
  if (!old.empty() && !force) {
    throw configuration_error(folder_.string(), "holds graphs already", "remove them with --force");
  }
  for (const auto& file : old) std::filesystem::remove(file);
}

void WindowDump::write(const WindowGraph& window) {
  copy(window, graph_);
  const std::filesystem::path file = folder_ / fmt::format("{:06}.g2o", next_++);
  std::ofstream out(file, std::ios::binary);
  write_g2o(out, {graph_, {}, {}});
  out.close();
  if (!out) throw input_error(file.string(), "could not be written", "is there room on the disk?");
}

}  // namespace lanefuse
