// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lanefuse {

/// A table of numbers as NumPy stores it in a .npy file, whatever the file's ending. A one-dimensional array
/// is a table of one column.
class NpyTable {
 public:
  NpyTable(std::size_t rows, std::size_t columns, std::vector<double> row_major);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
    return values_[row * columns_ + column];
  }

 private:
  std::size_t rows_;
  std::size_t columns_;
  std::vector<double> values_;
};

/// Reads format versions 1 and 2 with one or two dimensions of little-endian floats (4, 8 bytes), whole
/// numbers (1 to 8 bytes, up to 2^53) or truth values, in C or Fortran order. All lengths are checked against
/// the file's before anything is allocated. Throws Error, naming the file and the reason, for everything
/// else.
NpyTable read_npy(const std::filesystem::path& file);

/// The same from memory; `place` names it in errors.
NpyTable parse_npy(std::string_view bytes, const std::string& place);

}  // namespace lanefuse
