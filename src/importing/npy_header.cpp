// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/npy_header.hpp"

#include <cctype>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

/// Walks through the few Python literals that a header may hold.
class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& place) : text_(text), place_(place) {}

  NpyHeader read() {
    NpyHeader header;
    expect('{');
    while (!accept('}')) {
      const std::string key = read_string();
      expect(':');
      read_entry(key, header);
      if (!accept(',')) {
        expect('}');
        break;
      }
    }
    skip_space();
    if (at_ != text_.size()) fail("something stands behind the dictionary");
    if (seen_ != kAllEntries) fail("'descr', 'fortran_order' and 'shape' are needed once each");
    return header;
  }

 private:
  static constexpr int kType = 1;
  static constexpr int kOrder = 2;
  static constexpr int kShape = 4;
  static constexpr int kAllEntries = kType | kOrder | kShape;

  void read_entry(const std::string& key, NpyHeader& header) {
    if (key == "descr") {
      note_entry(kType);
      header.type = read_type();
    } else if (key == "fortran_order") {
      note_entry(kOrder);
      header.fortran_order = read_bool();
    } else if (key == "shape") {
      note_entry(kShape);
      header.shape = read_shape();
    } else {
      fail(fmt::format("unknown entry '{}'", key));
    }
  }

  void note_entry(int entry) {
    if (seen_ & entry) fail("an entry stands there twice");
    seen_ |= entry;
  }

  std::string read_type() {
    if (peek() == '[') fail("structured arrays are not read");
    return read_string();
  }

  bool read_bool() {
    skip_space();
    for (const std::string_view word : {"True", "False"}) {
      if (text_.substr(at_, word.size()) == word) {
        at_ += word.size();
        return word == "True";
      }
    }
    fail("'fortran_order' is neither True nor False");
  }

  std::vector<std::size_t> read_shape() {
    std::vector<std::size_t> shape;
    expect('(');
    while (!accept(')')) {
      shape.push_back(read_size());
      if (!accept(',')) {
        expect(')');
        break;
      }
    }
    return shape;
  }

  std::size_t read_size() {
    skip_space();
    const std::size_t begin = at_;
    std::size_t size = 0;
    for (; at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])); ++at_) {
      const auto digit = static_cast<std::size_t>(text_[at_] - '0');
      if (size > (std::numeric_limits<std::size_t>::max() - digit) / 10) fail("a size beyond all bounds");
      size = size * 10 + digit;
    }
    if (at_ == begin) fail("the shape is not a tuple of sizes");
    if (at_ < text_.size() && text_[at_] == 'L') ++at_;  // written by Python 2
    return size;
  }

  std::string read_string() {
    const char quote = peek();
    if (quote != '\'' && quote != '"') fail("a quoted word is missing");
    const std::size_t end = text_.find(quote, ++at_);
    if (end == std::string_view::npos) fail("a quotation does not end");
    std::string word(text_.substr(at_, end - at_));
    at_ = end + 1;
    return word;
  }

  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  char peek() {
    skip_space();
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool accept(char c) {
    if (peek() != c || at_ == text_.size()) return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!accept(c)) fail(fmt::format("'{}' is missing", c));
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw input_error(place_, fmt::format("header, character {}: {}", at_, problem));
  }

  std::string_view text_;
  const std::string& place_;
  std::size_t at_ = 0;
  int seen_ = 0;
};

}  // namespace

NpyHeader parse_npy_header(std::string_view text, const std::string& place) {
  return HeaderReader(text, place).read();
}

}  // namespace lanefuse
