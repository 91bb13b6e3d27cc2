// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lanefuse {

/// Numbers as a reader wants them; "-" for what is not known.
std::string metres(double value);  ///< two digits behind the point, the minus only where one of them is not 0
std::string percent(double share);         ///< of a share in [0, 1], one digit behind the point, 100 without
std::string grouped(std::uint64_t count);  ///< 12,263
std::string factor(double value);          ///< a ratio: three digits or more

/// A table of numbers with one or two rows of headings.
class HtmlTable {
 public:
  /// A row of headings over several columns each: text and number of columns.
  void group_headings(const std::vector<std::pair<std::string, int>>& groups);
  void headings(const std::vector<std::string>& names);
  void row(const std::vector<std::string>& cells);
  /// The whole table; headings and cells are escaped.
  [[nodiscard]] std::string html() const;

 private:
  void row_of(std::string& part, const char* tag, const std::vector<std::string>& cells);

  std::string head_;
  std::string body_;
  std::set<std::size_t> group_starts_;  // columns that stand off from the one before
};

}  // namespace lanefuse
