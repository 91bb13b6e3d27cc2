// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/map_text.hpp"

#include <cstdint>
#include <fstream>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr std::uintmax_t kMostBytes = 64 * 1024 * 1024;

}  // namespace

std::string read_map_text(const std::filesystem::path& path) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) throw input_error(path.string(), "is no file");
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (failed) throw input_error(path.string(), "cannot be read");
  if (size == 0) throw input_error(path.string(), "is empty");
  if (size > kMostBytes) {
    throw input_error(path.string(),
                      fmt::format("has {} bytes, more than the {} that a map may", size, kMostBytes),
                      "cut the map into smaller ones");
  }
  std::string text(size, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(text.data(), static_cast<std::streamsize>(size))) {
    throw input_error(path.string(), "cannot be read");
  }
  return text;
}

std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else {
      escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

}  // namespace lanefuse
