// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/config.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "pipeline/settings.hpp"

namespace lanefuse {
namespace {

std::string place_of(const std::string& name, const YAML::Mark& mark) {
  return mark.is_null() ? name : fmt::format("{}:{}", name, mark.line + 1);
}

/// Applies one YAML node below `prefix` to the settings.
void apply(const YAML::Node& node, const std::string& prefix, const std::string& name,
           const std::vector<Setting>& settings) {
  if (node.IsNull()) return;
  if (!node.IsMap()) {
    // The prefix ends with the dot before the next key; the file itself has none.
    const auto key = std::string_view(prefix).substr(0, prefix.empty() ? 0 : prefix.size() - 1);
    throw configuration_error(place_of(name, node.Mark()), fmt::format("'{}' is not a section of keys", key));
  }
  for (const auto& entry : node) {
    const auto key = prefix + entry.first.as<std::string>();
    const std::string place = place_of(name, entry.first.Mark());
    const auto setting =
        std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.key == key; });
    if (setting == settings.end()) {
      const bool is_section = std::any_of(settings.begin(), settings.end(), [&](const Setting& s) {
        return s.key.starts_with(fmt::format("{}.", key));
      });
      if (!is_section) {
        throw configuration_error(place, fmt::format("unknown key '{}'", key),
                                  "'lanefuse run --print-config' lists every key");
      }
      apply(entry.second, fmt::format("{}.", key), name, settings);
      continue;
    }
    if (!entry.second.IsScalar() || !setting->set(entry.second.Scalar())) {
      const std::string given = entry.second.IsScalar() ? entry.second.Scalar() : "a structure";
      throw configuration_error(place, fmt::format("'{}' cannot be {}", key, given),
                                fmt::format("allowed: {} {}", setting->allowed, setting->unit));
    }
  }
}

/// A value as YAML reads it back: in quotes where it is anything but a number, a word or a plain path.
std::string scalar(const std::string& value) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-/";
  if (!value.empty() && value.find_first_not_of(kPlain) == std::string::npos) return value;
  std::string quoted = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

void check(const PerceptionConfig& config, const std::string& name) {
  if (config.lanes.lane_width_min >= config.lanes.lane_width_max) {
    throw configuration_error(name, "'lanes.lane_width_min' is not below 'lanes.lane_width_max'");
  }
  if (config.lanes.base.range_begin >= config.lanes.base.range_end) {
    throw configuration_error(name, "'lanes.base.range_begin' is not below 'lanes.base.range_end'");
  }
}

}  // namespace

const char* to_string(EstimatorKind kind) { return kind == EstimatorKind::road ? "road" : "graph"; }

PerceptionConfig default_config(WitnessRule rule) {
  PerceptionConfig config;
  if (rule == WitnessRule::radar_only) {
    config.sources.objects.witness.rule = rule;
    config.sources.objects.sensors.long_range_radar = unknown_radar_config();
    // Its bearings alone must tell where a vehicle is across: they need the longer look.
    config.sources.objects.tracker.acceleration_across = 0.12;
    config.sources.ego_path.enabled = true;
    config.lanes.base.fit = BaseFit::joint;
    config.lanes.base.position_sigma = config.sources.objects.witness.driver_sigma;
  }
  return config;
}

PerceptionConfig parse_config(const std::string& yaml, const std::string& name,
                              const PerceptionConfig& defaults) {
  PerceptionConfig config = defaults;
  const std::vector<Setting> settings = settings_of(config);
  try {
    const YAML::Node root = YAML::Load(yaml);
    apply(root, "", name, settings);
  } catch (const YAML::Exception& e) {
    throw configuration_error(place_of(name, e.mark), fmt::format("not YAML: {}", e.msg));
  }
  check(config, name);
  return config;
}

PerceptionConfig load_config(const std::filesystem::path& file, const PerceptionConfig& defaults) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  if (!in || std::filesystem::is_directory(file)) throw configuration_error(file.string(), "cannot be read");
  return parse_config(text.str(), file.string(), defaults);
}

void set_key(PerceptionConfig& config, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw configuration_error(fmt::format("--set {}", assignment), "is no assignment", "write KEY=VALUE");
  }
  YAML::Node node(assignment.substr(equals + 1));
  std::string key = assignment.substr(0, equals);
  for (auto dot = key.rfind('.'); dot != std::string::npos; dot = key.rfind('.')) {
    YAML::Node parent;
    parent[key.substr(dot + 1)] = node;
    node.reset(parent);
    key.resize(dot);
  }
  YAML::Node root;
  root[key] = node;
  config = parse_config(YAML::Dump(root), fmt::format("--set {}", assignment), config);
}

std::string fingerprint(const PerceptionConfig& config) {
  return fmt::format("{:016x}", fnv1a(to_yaml(config)));
}

std::string to_yaml(const PerceptionConfig& config) {
  PerceptionConfig copy = config;
  std::string yaml;
  std::vector<std::string> open;  // the sections that the last key stood in
  for (const Setting& setting : settings_of(copy)) {
    std::vector<std::string> path;
    std::stringstream parts(setting.key);
    for (std::string part; std::getline(parts, part, '.');) path.push_back(part);
    std::size_t common = 0;
    while (common < open.size() && common + 1 < path.size() && open[common] == path[common]) ++common;
    for (std::size_t i = common; i + 1 < path.size(); ++i)
      yaml += fmt::format("{:{}}{}:\n", "", 2 * i, path[i]);
    open.assign(path.begin(), path.end() - 1);
    const std::string unit = setting.unit.empty() ? "" : fmt::format(" [{}]", setting.unit);
    yaml += fmt::format("{:{}}{}: {}  # {}{}; {}\n", "", 2 * open.size(), path.back(), scalar(setting.get()),
                        setting.effect, unit, setting.allowed);
  }
  return yaml;
}

}  // namespace lanefuse
