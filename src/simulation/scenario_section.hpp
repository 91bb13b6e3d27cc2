// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "simulation/preset.hpp"

namespace lanefuse {

/// One map of a scenario file, read strictly: what is unknown, there twice, of the wrong kind or out of range
/// is a configuration error that names file, line and key ("night.yaml, line 7, ego.speed_mps"). Every key
/// may be left out unless it is said to be needed.
class ScenarioSection {
 public:
  ScenarioSection(const YAML::Node& node, std::string place, std::string path = {});

  std::optional<ScenarioSection> section(const std::string& key);
  /// A list of maps; empty where the key is not there.
  std::vector<ScenarioSection> list(const std::string& key);
  /// A list of words, each one of `words`, as indices; empty where the key is not there.
  std::vector<std::size_t> choices(const std::string& key, std::span<const char* const> words);
  std::optional<std::string> text(const std::string& key);
  std::optional<bool> flag(const std::string& key);
  std::optional<double> number(const std::string& key, Range allowed);
  /// A number, or the word "never", which is infinity.
  std::optional<double> number_or_never(const std::string& key, Range allowed);
  double needed_number(const std::string& key, Range allowed);
  /// The index of the word among `words`.
  std::optional<std::size_t> choice(const std::string& key, std::span<const char* const> words);
  std::size_t needed_choice(const std::string& key, std::span<const char* const> words);

  /// How errors name the key's place, or the whole section's where the key is empty.
  [[nodiscard]] std::string place_of(const std::string& key) const;

  /// To be called when all is read: complains of what nobody asked for.
  void finish() const;

  /// Throws that something is wrong with the key's value, or with the whole section where the key is empty.
  [[noreturn]] void refuse(const std::string& key, const std::string& problem,
                           const std::string& mend = {}) const;

 private:
  YAML::Node node_;
  std::string place_;
  std::string path_;
  std::set<std::string> asked_;

  std::optional<YAML::Node> take(const std::string& key);
  [[nodiscard]] std::string path_of(const std::string& key) const;
  std::size_t index_of(const YAML::Node& word, const std::string& key,
                       std::span<const char* const> words) const;
};

}  // namespace lanefuse
