// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace lanefuse::testing {

/// A .npy file's bytes: what NumPy itself would write for this header and these numbers.
template <typename Number>
std::string npy_bytes(const std::string& header, const std::vector<Number>& numbers, char version = 1) {
  const std::string text = header + "\n";
  std::string bytes = "\x93NUMPY";
  bytes += {version, '\0'};
  for (std::size_t i = 0; i < (version == 1 ? 2 : 4); ++i)
    bytes += static_cast<char>(text.size() >> (8 * i) & 0xffU);
  bytes += text;
  const std::size_t begin = bytes.size();
  bytes.resize(begin + numbers.size() * sizeof(Number));
  if (!numbers.empty()) std::memcpy(bytes.data() + begin, numbers.data(), numbers.size() * sizeof(Number));
  return bytes;
}

inline std::string npy_header(const std::string& type, const std::string& shape, bool fortran = false) {
  return fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': {}, }}", type,
                     fortran ? "True" : "False", shape);
}

inline void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Rows of equal length as a C-ordered array of doubles.
inline void write_table(const std::filesystem::path& file, const std::vector<std::vector<double>>& rows) {
  std::vector<double> numbers;
  for (const auto& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  write_file(file, npy_bytes(npy_header("<f8", fmt::format("({}, {})", rows.size(), columns)), numbers));
}

inline void write_list(const std::filesystem::path& file, const std::vector<double>& numbers) {
  write_file(file, npy_bytes(npy_header("<f8", fmt::format("({},)", numbers.size())), numbers));
}

}  // namespace lanefuse::testing
