// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/text_grid.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace lanefuse {
namespace {

/// Of UTF-8 text: "±" is one letter and two bytes.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string laid_out(const TextRow& row, const std::vector<std::size_t>& widths, bool markdown) {
  std::string line = markdown ? "|" : "";
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto width = markdown ? 0 : widths[i];
    const std::string cell =
        i == 0 ? fmt::format("{:<{}}", row[i], width) : fmt::format("{:>{}}", row[i], width);
    line += markdown ? fmt::format(" {} |", cell) : fmt::format("{}{}", i == 0 ? "" : "  ", cell);
  }
  return line + "\n";
}

}  // namespace

std::string text_grid(const std::vector<TextRow>& rows, bool markdown) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const TextRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters(row[i]));
  }
  std::string text;
  for (const TextRow& row : rows) {
    text += laid_out(row, widths, markdown);
    if (markdown && &row == &rows.front()) {
      for (std::size_t i = 0; i < row.size(); ++i) text += "|---";
      text += "|\n";
    }
  }
  return text;
}

}  // namespace lanefuse
