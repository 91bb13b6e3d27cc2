// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pipeline/config.hpp"

namespace lanefuse {

/// One key of the configuration: where its value lives, what it does, and what it may be.
struct Setting {
  std::string key;   ///< "fusion.association.along"
  std::string unit;  ///< "m", empty for none
  std::string effect;
  std::string allowed;  ///< "0.1 .. 50", "true, false", "heading, joint"
  std::function<std::string()> get;
  /// Takes the text of a YAML scalar; false if it is not allowed.
  std::function<bool(const std::string&)> set;
};

/// Every key there is, in the order in which it is written out, bound to `config`.
std::vector<Setting> settings_of(PerceptionConfig& config);

}  // namespace lanefuse
