// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/output_file.hpp"

#include <fstream>

#include "core/error.hpp"

namespace lanefuse {

void check_output(const std::filesystem::path& output, bool force, const std::filesystem::path& input) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!input.empty() && fs::equivalent(output, input, ignored)) {
    throw configuration_error(output.string(), "is the input, too", "choose another output");
  }
  if (fs::is_directory(output, ignored)) throw configuration_error(output.string(), "is a folder");
  if (!force && fs::exists(output, ignored)) {
    throw configuration_error(output.string(), "is there already", "overwrite it with --force");
  }
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    throw configuration_error(output.string(), "cannot be written: its folder is not there",
                              "make " + folder.string());
  }
}

void write_text(const std::filesystem::path& output, const std::string& text) {
  const std::filesystem::path part = output.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, output, failed);
  if (!out || failed) {
    std::filesystem::remove(part, failed);
    throw input_error(output.string(), "could not be written", "is there room on the disk?");
  }
}

}  // namespace lanefuse
