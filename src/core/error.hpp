// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace lanefuse {

/// The one error for what the world does wrong: a damaged file, an impossible value, a misspelt key.
/// It names the place and, where there is one, the mend. Programmer's errors are asserted instead.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    configuration,  ///< wrong use or configuration: the program exits with 2
    input,          ///< bad input: the program exits with 3
  };

  /// `place` says where ("drive.mcap, byte 605"), `problem` what is wrong, `mend` what to do about it (may be
  /// empty).
  Error(Kind kind, const std::string& place, const std::string& problem, const std::string& mend = {})
      : std::runtime_error(place + ": " + problem + (mend.empty() ? "" : "; " + mend)), kind_(kind) {}

  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

inline Error configuration_error(const std::string& place, const std::string& problem,
                                 const std::string& mend = {}) {
  return {Error::Kind::configuration, place, problem, mend};
}

inline Error input_error(const std::string& place, const std::string& problem, const std::string& mend = {}) {
  return {Error::Kind::input, place, problem, mend};
}

}  // namespace lanefuse
