// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lanefuse {

/// Numbers as a reader wants them; "-" for what is not known.
std::string metres(double value);  ///< two digits behind the point, the minus only where one of them is not 0
std::string percent(double share);  ///< of a share in [0, 1], one digit behind the point, 100 without
std::string factor(double value);   ///< a ratio: two digits behind the point while it is small

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
  std::string head_;
  std::string body_;
};

}  // namespace lanefuse
