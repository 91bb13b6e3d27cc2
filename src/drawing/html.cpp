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
  return share == 1 ? "100 %" : fmt::format("{:.1f} %", 100 * share);
}

std::string factor(double value) {
  if (!std::isfinite(value)) return "-";
  return value < 10 ? fmt::format("{:.2f}", value) : fmt::format("{:.0f}", value);
}

void HtmlTable::group_headings(const std::vector<std::pair<std::string, int>>& groups) {
  head_ += "<tr>";
  for (const auto& [name, columns] : groups) {
    head_ += fmt::format(R"(<th class="group" colspan="{}">{}</th>)", columns, escape_xml(name));
  }
  head_ += "</tr>\n";
}

void HtmlTable::headings(const std::vector<std::string>& names) {
  head_ += "<tr>";
  for (const std::string& name : names) head_ += "<th>" + escape_xml(name) + "</th>";
  head_ += "</tr>\n";
}

void HtmlTable::row(const std::vector<std::string>& cells) {
  body_ += "<tr>";
  for (const std::string& cell : cells) body_ += "<td>" + escape_xml(cell) + "</td>";
  body_ += "</tr>\n";
}

std::string HtmlTable::html() const {
  return "<div class=\"scroll\"><table>\n<thead>" + head_ + "</thead>\n<tbody>" + body_ +
         "</tbody>\n</table></div>\n";
}

}  // namespace lanefuse
