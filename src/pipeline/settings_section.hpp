// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pipeline/settings.hpp"

namespace lanefuse {

template <typename T>
concept Numeric = std::floating_point<T> ||(std::integral<T> && !std::same_as<T, bool>);

/// The whole text as a number, or false.
template <Numeric Number>
bool parse_number(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Collects the settings below one key.
class Section {
 public:
  Section(std::vector<Setting>& settings, std::string prefix)
      : settings_(settings), prefix_(std::move(prefix)) {}

  template <Numeric Number>
  void add(const char* key, Number& value, std::pair<Number, Number> range, const char* unit,
           const char* effect) const {
    settings_.push_back({prefix_ + key, unit, effect, fmt::format("{} .. {}", range.first, range.second),
                         [&value] { return fmt::format("{}", value); },
                         [&value, range](const std::string& text) {
                           Number number{};
                           if (!parse_number(text, number) ||
                               !(number >= range.first && number <= range.second)) {
                             return false;
                           }
                           value = number;
                           return true;
                         }});
  }

  void add(const char* key, bool& value, const char* effect) const {
    settings_.push_back({prefix_ + key, "", effect, "true, false",
                         [&value] { return value ? "true" : "false"; },
                         [&value](const std::string& text) {
                           if (text != "true" && text != "false") return false;
                           value = text == "true";
                           return true;
                         }});
  }

  /// Any text, of a file's name for one.
  void add(const char* key, std::string& value, const char* effect) const {
    settings_.push_back({prefix_ + key, "", effect, "text", [&value] { return quoted(value); },
                         [&value](const std::string& text) {
                           if (text.find_first_of("\n\r") != std::string::npos) return false;
                           value = text;
                           return true;
                         }});
  }

  /// A choice among names; the names are in the order of the enumeration's values.
  template <typename Choice>
  void add(const char* key, Choice& value, const std::vector<std::string>& names, const char* effect) const {
    settings_.push_back({prefix_ + key, "", effect, fmt::format("{}", fmt::join(names, ", ")),
                         [&value, names] { return names[static_cast<std::size_t>(value)]; },
                         [&value, names](const std::string& text) {
                           for (std::size_t i = 0; i < names.size(); ++i) {
                             if (names[i] != text) continue;
                             value = static_cast<Choice>(i);
                             return true;
                           }
                           return false;
                         }});
  }

  [[nodiscard]] Section section(const std::string& key) const { return {settings_, prefix_ + key + "."}; }

 private:
  /// As YAML and JSON write text.
  static std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
    return out + '"';
  }

  std::vector<Setting>& settings_;
  std::string prefix_;
};

}  // namespace lanefuse
