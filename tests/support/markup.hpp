// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>
#include <vector>

/// What pictures and pages are held to.
namespace lanefuse::testing {

/// The first thing that keeps `markup` from being well-formed XML (elements balanced, attributes quoted,
/// ampersands escaped), or nothing. A leading doctype is passed over.
inline std::string malformed(std::string markup) {
  static const std::regex kTag(
      R"re(<(/?)([A-Za-z][A-Za-z0-9]*)((?: [A-Za-z][A-Za-z0-9-]*="[^"<]*")*)(/?)>)re");
  static const std::regex kStray(R"re(&(?!(?:amp|lt|gt|quot|#[0-9]+);))re");
  static const std::string kDoctype = "<!DOCTYPE html>";
  if (markup.starts_with(kDoctype)) markup.erase(0, kDoctype.size());
  std::smatch stray;
  if (std::regex_search(markup, stray, kStray))
    return "a bare ampersand at " + std::to_string(stray.position());
  std::vector<std::string> open;
  std::size_t tags = 0;
  for (std::sregex_iterator tag(markup.begin(), markup.end(), kTag), end; tag != end; ++tag, ++tags) {
    const bool closes = (*tag)[1].length() > 0;
    const bool empty = (*tag)[4].length() > 0;
    const std::string name = (*tag)[2];
    if (closes && (open.empty() || open.back() != name)) return "</" + name + "> closes what is not open";
    if (closes) open.pop_back();
    if (!closes && !empty) open.push_back(name);
  }
  if (!open.empty()) return "<" + open.back() + "> is never closed";
  const auto angles = static_cast<std::size_t>(std::count(markup.begin(), markup.end(), '<'));
  return angles == tags ? "" : "a < that begins no tag";
}

/// Whether a number that is none was printed.
inline bool prints_nan(const std::string& text) {
  static const std::regex kNumberless(R"(\b(nan|inf)\b)", std::regex::icase);
  return std::regex_search(text, kNumberless);
}

/// Everything that looks like an address, but for the name of SVG itself.
inline std::vector<std::string> addresses(const std::string& markup) {
  static const std::regex kAddress(
      R"re((?:[a-z]+:)?//[^ "'<>)]+|url\([^)]*\)|@import|<script|<link|\bsrc=|\bhref=)re");
  std::vector<std::string> found;
  for (std::sregex_iterator hit(markup.begin(), markup.end(), kAddress), end; hit != end; ++hit) {
    if (hit->str() != "http://www.w3.org/2000/svg") found.push_back(hit->str());
  }
  return found;
}

inline int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++count;
  return count;
}

}  // namespace lanefuse::testing
