// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/image_file.hpp"

#include <cstddef>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "camera/image_codec.hpp"

namespace lanefuse {

std::optional<Image> read_image(const std::filesystem::path& file) {
  constexpr std::uintmax_t kLargestFile = 256 << 20;  // [bytes]
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in || size > kLargestFile) return {};
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return decode_image(std::as_bytes(std::span(text)));
}

}  // namespace lanefuse
