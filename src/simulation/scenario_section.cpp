// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

std::optional<double> as_number(const YAML::Node& node) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) return {};
  return value;
}

int line_of(const YAML::Node& node) {
  return std::max(node.Mark().line, 0) + 1;
}  // nothing in the file: no mark

std::string key_of(const YAML::Node& key) { return key.IsScalar() ? key.Scalar() : "(not a name)"; }

}  // namespace

ScenarioSection::ScenarioSection(const YAML::Node& node, std::string place, std::string path)
    : node_(node), place_(std::move(place)), path_(std::move(path)) {
  if (!node_.IsMap()) refuse("", "is not a map of keys");
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    const std::string key = key_of(entry.first);
    if (!seen.insert(key).second) refuse(key, "is there twice");
  }
}

std::string ScenarioSection::path_of(const std::string& key) const {
  if (key.empty()) return path_;
  return path_.empty() ? key : fmt::format("{}.{}", path_, key);
}

std::string ScenarioSection::place_of(const std::string& key) const {
  int line = line_of(node_);
  if (node_.IsMap()) {
    for (const auto& entry : node_) {
      if (key_of(entry.first) == key) line = line_of(entry.first);
    }
  }
  const std::string path = path_of(key);
  return fmt::format("{}, line {}{}{}", place_, line, path.empty() ? "" : ", ", path);
}

void ScenarioSection::refuse(const std::string& key, const std::string& problem,
                             const std::string& mend) const {
  throw configuration_error(place_of(key), problem, mend);
}

std::optional<YAML::Node> ScenarioSection::take(const std::string& key) {
  asked_.insert(key);
  const YAML::Node child = std::as_const(node_)[key];
  if (!child.IsDefined()) return {};
  return child;
}

std::optional<ScenarioSection> ScenarioSection::section(const std::string& key) {
  const std::optional<YAML::Node> child = take(key);
  if (!child) return {};
  if (!child->IsMap()) refuse(key, "is not a map of keys");
  return ScenarioSection(*child, place_, path_of(key));
}

std::vector<ScenarioSection> ScenarioSection::list(const std::string& key) {
  const std::optional<YAML::Node> child = take(key);
  if (!child) return {};
  if (!child->IsSequence()) refuse(key, "is not a list");
  std::vector<ScenarioSection> sections;
  for (const YAML::Node& item : *child) {
    sections.emplace_back(item, place_, fmt::format("{}[{}]", path_of(key), sections.size() + 1));
  }
  return sections;
}

std::optional<std::string> ScenarioSection::text(const std::string& key) {
  const std::optional<YAML::Node> child = take(key);
  if (!child) return {};
  if (!child->IsScalar() || child->Scalar().empty()) refuse(key, "is not a text");
  return child->Scalar();
}

std::optional<bool> ScenarioSection::flag(const std::string& key) {
  const std::optional<YAML::Node> child = take(key);
  if (!child) return {};
  bool value = false;
  if (!child->IsScalar() || !YAML::convert<bool>::decode(*child, value))
    refuse(key, "is neither true nor false");
  return value;
}

std::optional<double> ScenarioSection::number(const std::string& key, Range allowed) {
  const std::optional<YAML::Node> child = take(key);
  if (!child) return {};
  const std::optional<double> value = as_number(*child);
  if (!value) refuse(key, "is not a number");
  if (*value < allowed.low || *value > allowed.high) {
    refuse(key, fmt::format("is {}, which is not in [{}, {}]", *value, allowed.low, allowed.high));
  }
  return value;
}

std::optional<double> ScenarioSection::number_or_never(const std::string& key, Range allowed) {
  const std::optional<YAML::Node> child = take(key);
  if (child && child->IsScalar() && child->Scalar() == "never") return INFINITY;
  if (child && !as_number(*child)) refuse(key, "is neither a number nor never");
  return number(key, allowed);
}

double ScenarioSection::needed_number(const std::string& key, Range allowed) {
  const std::optional<double> value = number(key, allowed);
  if (!value) refuse("", fmt::format("has no key {}", key));
  return *value;
}

std::size_t ScenarioSection::index_of(const YAML::Node& word, const std::string& key,
                                      std::span<const char* const> words) const {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (word.IsScalar() && word.Scalar() == words[i]) return i;
  }
  refuse(key, fmt::format("{} is not known", word.IsScalar() ? word.Scalar() : "what it says"),
         fmt::format("choose from {}", fmt::join(words, ", ")));
}

std::optional<std::size_t> ScenarioSection::choice(const std::string& key,
                                                   std::span<const char* const> words) {
  const std::optional<YAML::Node> child = take(key);
  if (!child) return {};
  return index_of(*child, key, words);
}

std::size_t ScenarioSection::needed_choice(const std::string& key, std::span<const char* const> words) {
  const std::optional<std::size_t> index = choice(key, words);
  if (!index) refuse("", fmt::format("has no key {}", key));
  return *index;
}

std::vector<std::size_t> ScenarioSection::choices(const std::string& key,
                                                  std::span<const char* const> words) {
  const std::optional<YAML::Node> child = take(key);
  if (!child) return {};
  if (!child->IsSequence()) refuse(key, "is not a list");
  std::vector<std::size_t> indices;
  for (const YAML::Node& item : *child) indices.push_back(index_of(item, key, words));
  return indices;
}

void ScenarioSection::finish() const {
  for (const auto& entry : node_) {
    const std::string key = key_of(entry.first);
    if (!asked_.contains(key))
      refuse(key, "is an unknown key", fmt::format("known here: {}", fmt::join(asked_, ", ")));
  }
}

}  // namespace lanefuse
