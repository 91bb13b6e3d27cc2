// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace lanefuse {

/// One line of a g2o file, taken apart word by word. Whatever is wrong with it is told with its place.
class G2oLine {
 public:
  G2oLine(std::string_view text, const std::string& file, std::size_t number);

  /// The next word, empty at the end of the line or at a comment.
  std::string_view word();
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  std::int64_t id();
  double number();
  /// Refuses whatever is still there.
  void finish();

  [[nodiscard]] Error error(const std::string& problem, const std::string& mend = {}) const;

 private:
  std::string_view rest_;
  const std::string& file_;
  std::size_t line_number_;
};

/// A word as it can be shown in a message: short and printable.
std::string shown(std::string_view word);

}  // namespace lanefuse
