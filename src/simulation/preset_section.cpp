// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/preset_section.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/error.hpp"

namespace lanefuse {
namespace {

std::optional<double> as_number(const YAML::Node& node) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) return {};
  return value;
}

bool is_count(double value) { return value >= 0 && value <= 1000 && value == std::floor(value); }

}  // namespace

PresetSection::PresetSection(const YAML::Node& node, std::string place, std::string path)
    : node_(node), place_(std::move(place)), path_(std::move(path)) {
  if (!node_.IsMap())
    throw configuration_error(place_ + (path_.empty() ? "" : ", " + path_), "is not a map of keys");
}

std::string PresetSection::name(const std::string& key) const {
  return place_ + ", " + (path_.empty() ? "" : path_ + ".") + key;
}

YAML::Node PresetSection::take(const std::string& key) {
  asked_.insert(key);
  const YAML::Node child = std::as_const(node_)[key];
  if (!child.IsDefined()) throw configuration_error(name(key), "is missing");
  return child;
}

PresetSection PresetSection::section(const std::string& key) {
  return {take(key), place_, path_.empty() ? key : path_ + "." + key};
}

double PresetSection::number(const std::string& key) {
  const std::optional<double> value = as_number(take(key));
  if (!value || *value < 0) throw configuration_error(name(key), "is not a number of at least zero");
  return *value;
}

double PresetSection::positive(const std::string& key) {
  const double value = number(key);
  if (!(value > 0)) throw configuration_error(name(key), "must be above zero");
  return value;
}

double PresetSection::share(const std::string& key) {
  const double value = number(key);
  if (value > 1) throw configuration_error(name(key), "must be in [0, 1]");
  return value;
}

double PresetSection::degrees(const std::string& key) { return number(key) * std::numbers::pi / 180; }

/// Two numbers in order.
std::optional<Range> PresetSection::pair(const std::string& key) {
  const YAML::Node node = take(key);
  const bool is_pair = node.IsSequence() && node.size() == 2;
  const std::optional<double> low = is_pair ? as_number(node[0]) : std::nullopt;
  const std::optional<double> high = is_pair ? as_number(node[1]) : std::nullopt;
  if (!low || !high || *high < *low) return {};
  return Range{*low, *high};
}

Range PresetSection::range(const std::string& key) {
  const std::optional<Range> range = pair(key);
  if (!range || !(range->low > 0)) {
    throw configuration_error(name(key), "is not a range of two positive numbers", "write [low, high]");
  }
  return *range;
}

int PresetSection::count(const std::string& key) {
  const double value = number(key);
  if (!is_count(value)) throw configuration_error(name(key), "is not a whole number up to 1000");
  return static_cast<int>(value);
}

Range PresetSection::counts(const std::string& key) {
  const std::optional<Range> range = pair(key);
  if (!range || !is_count(range->low) || !is_count(range->high)) {
    throw configuration_error(name(key), "is not a range of two whole numbers up to 1000",
                              "write [low, high]");
  }
  return *range;
}

void PresetSection::expect(const std::string& key, const std::string& value) {
  const YAML::Node node = take(key);
  if (!node.IsScalar() || node.Scalar() != value) {
    throw configuration_error(name(key), "is not known", "this program reads only \"" + value + "\"");
  }
}

void PresetSection::leave(const std::string& key) { take(key); }

void PresetSection::finish() const {
  for (const auto& entry : node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "(not a name)";
    if (!asked_.contains(key)) throw configuration_error(name(key), "is an unknown key");
  }
}

}  // namespace lanefuse
