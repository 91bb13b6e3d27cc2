// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>

#include <yaml-cpp/yaml.h>

#include "simulation/preset.hpp"

namespace lanefuse {

/// One map of a preset file, read strictly: a key that is missing, of the wrong kind or never asked for is a
/// configuration error naming it by its full path ("nominal-preset.yaml, camera_pose.height_m").
class PresetSection {
 public:
  PresetSection(const YAML::Node& node, std::string place, std::string path = {});

  PresetSection section(const std::string& key);
  double number(const std::string& key);    ///< finite and not negative
  double positive(const std::string& key);  ///< finite and above zero
  double share(const std::string& key);     ///< in [0, 1]
  double degrees(const std::string& key);   ///< in the file; radians here
  Range range(const std::string& key);      ///< two positive numbers, in order
  int count(const std::string& key);        ///< a whole number of at least zero
  Range counts(const std::string& key);     ///< two of them, in order
  void expect(const std::string& key, const std::string& value);
  /// For parts that are said for people.
  void leave(const std::string& key);

  /// To be called when all is read: complains of what nobody asked for.
  void finish() const;

 private:
  YAML::Node node_;
  std::string place_;
  std::string path_;
  std::set<std::string> asked_;

  YAML::Node take(const std::string& key);
  std::optional<Range> pair(const std::string& key);
  [[nodiscard]] std::string name(const std::string& key) const;
};

}  // namespace lanefuse
