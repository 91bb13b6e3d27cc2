// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/html.hpp"

#include <cmath>

#include <fmt/format.h>

#include "drawing/svg.hpp"

namespace lanefuse {

std::string metres(double value) {
  if (!std::isfinite(value)) return "-";
  const std::string text = fmt::format("{:.2f}", value);
  return text == "-0.00" ? "0.00" : text;
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "-";
  if (share == 1) return "100 %";
  // Rounding must not turn nearly into all, nor hardly any into none.
  if (share < 1 && share >= 0.9995) return "> 99.9 %";
  if (share > 0 && share < 0.0005) return "< 0.1 %";
  return fmt::format("{:.1f} %", 100 * share);
}

std::string grouped(std::uint64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string factor(double value) {
  if (!std::isfinite(value)) return "-";
  return fmt::format("{:.{}f}", value, value < 10 ? 2 : value < 100 ? 1 : 0);
}

void HtmlTable::group_headings(const std::vector<std::pair<std::string, int>>& groups) {
  head_ += "<tr>";
  std::size_t column = 0;
  for (const auto& [name, columns] : groups) {
    head_ += fmt::format(R"(<th class="group" colspan="{}">{}</th>)", columns, escape_xml(name));
    group_starts_.insert(column);
    column += static_cast<std::size_t>(columns);
  }
  head_ += "</tr>\n";
}

void HtmlTable::headings(const std::vector<std::string>& names) { row_of(head_, "th", names); }

void HtmlTable::row(const std::vector<std::string>& cells) { row_of(body_, "td", cells); }

void HtmlTable::row_of(std::string& part, const char* tag, const std::vector<std::string>& cells) {
  part += "<tr>";
  for (std::size_t column = 0; column < cells.size(); ++column) {
    const char* css = group_starts_.contains(column) ? " class=\"first\"" : "";
    part += fmt::format("<{0}{1}>{2}</{0}>", tag, css, escape_xml(cells[column]));
  }
  part += "</tr>\n";
}

std::string HtmlTable::html() const {
  return "<div class=\"scroll\"><table>\n<thead>" + head_ + "</thead>\n<tbody>" + body_ +
         "</tbody>\n</table></div>\n";
}

}  // namespace lanefuse
