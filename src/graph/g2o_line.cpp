// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/g2o_line.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace lanefuse {

namespace {

constexpr std::string_view kBlank = " \t\r\v\f";

std::string_view without_leading_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(kBlank);
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

/// The whole word as a number, or false.
template <typename Number>
bool parse(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  return problem == std::errc{} && end == word.data() + word.size();
}

}  // namespace

std::string shown(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

G2oLine::G2oLine(std::string_view text, const std::string& file, std::size_t number)
    : rest_(without_leading_blanks(text.substr(0, text.find('#')))), file_(file), line_number_(number) {}

std::string_view G2oLine::word() {
  const std::string_view result = rest_.substr(0, rest_.find_first_of(kBlank));
  rest_ = without_leading_blanks(rest_.substr(result.size()));
  return result;
}

std::int64_t G2oLine::id() {
  const std::string_view text = word();
  std::int64_t value = 0;
  if (text.empty()) throw error("the line ends where an id should stand");
  if (!parse(text, value)) throw error(shown(text) + " is not an id", "ids are whole numbers");
  return value;
}

double G2oLine::number() {
  const std::string_view text = word();
  double value = 0;
  if (text.empty()) throw error("the line ends where a number should stand");
  if (!parse(text, value)) throw error(shown(text) + " is not a number");
  if (!std::isfinite(value)) throw error(shown(text) + " is not a finite number");
  return value;
}

void G2oLine::finish() {
  if (!at_end()) throw error(shown(word()) + " is one value too many");
}

Error G2oLine::error(const std::string& problem, const std::string& mend) const {
  return input_error(fmt::format("{}:{}", file_, line_number_), problem, mend);
}

}  // namespace lanefuse
