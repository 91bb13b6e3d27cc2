// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace lanefuse {

/// A file of config/scenarios as it was when the program was built.
struct BuiltInScenarioText {
  std::string_view name;  ///< without its ending
  std::string_view text;
};

/// In the order of their files' names.
std::span<const BuiltInScenarioText> built_in_scenario_texts();

}  // namespace lanefuse
