// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "simulation/built_in_scenario_texts.hpp"
#include "simulation/scenario.hpp"

namespace lanefuse {

std::vector<std::string> built_in_scenario_names() {
  std::vector<std::string> names;
  for (const BuiltInScenarioText& scenario : built_in_scenario_texts()) names.emplace_back(scenario.name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string_view built_in_scenario_text(std::string_view name) {
  const auto texts = built_in_scenario_texts();
  const auto found = std::find_if(texts.begin(), texts.end(), [name](const BuiltInScenarioText& scenario) {
    return scenario.name == name;
  });
  if (found == texts.end()) {
    throw configuration_error(fmt::format("scenario {}", name), "is not known",
                              fmt::format("choose from {}", fmt::join(built_in_scenario_names(), ", ")));
  }
  return found->text;
}

Scenario built_in_scenario(std::string_view name) {
  return parse_scenario(built_in_scenario_text(name), fmt::format("{}.yaml", name));
}

Scenario find_scenario(const std::string& name_or_file) {
  const std::filesystem::path path(name_or_file);
  const bool is_file = path.has_extension() || path.has_parent_path();
  return is_file ? load_scenario(path) : built_in_scenario(name_or_file);
}

}  // namespace lanefuse
