// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/variant.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "benchmark/estimator_choice.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr auto kNothing = [](SimulationConfig&) {};

constexpr std::array<Variant, 7> kVariants{{
    {"full", "every source and every edge", kNothing, ""},
    {"no-objects", "no other vehicles as witnesses", [](SimulationConfig& c) { c.objects = false; }, ""},
    {"no-high-resolution-camera", "no marking features of the second camera",
     [](SimulationConfig& c) { c.high_resolution_camera = false; }, ""},
    {"no-serial-camera", "no lanes of the serial camera",
     [](SimulationConfig& c) { c.serial_camera = false; }, ""},
    {"no-width", "no edges across a lane (eq. 8)", kNothing, "fusion.width_edges=false"},
    {"no-smoothing", "no edges along a vehicle's trail (eq. 9)", kNothing, "fusion.smoothing_edges=false"},
    {"no-switches", "smoothing edges that cannot switch off", kNothing, "fusion.switchable=false"},
}};

/// No piece less, but other input: apart from the ablations, which are driven all together.
constexpr Variant kDetections{kDetectionsVariant,
                              "radars' and a camera's detections in place of the object list",
                              [](SimulationConfig& c) { c.detections = true; }, ""};

}  // namespace

std::span<const Variant> variants() { return kVariants; }

std::vector<std::string> variant_names() {
  std::vector<std::string> names;
  std::transform(kVariants.begin(), kVariants.end(), std::back_inserter(names),
                 [](const Variant& variant) { return std::string(variant.name); });
  return names;
}

const Variant& find_variant(std::string_view name) {
  if (name == kDetections.name) return kDetections;
  const auto found = std::find_if(kVariants.begin(), kVariants.end(),
                                  [name](const Variant& variant) { return variant.name == name; });
  if (found == kVariants.end()) {
    throw configuration_error("--variant", fmt::format("there is no '{}'", name),
                              fmt::format("choose among {}", fmt::join(variant_names(), ", ")));
  }
  return *found;
}

PerceptionConfig configure(const Variant& variant, std::string_view estimator,
                           std::span<const std::string> assignments) {
  PerceptionConfig config = default_config(WitnessRule::radar_and_camera);
  choose_estimator(config, estimator);
  const EstimatorKind chosen = config.estimator;
  if (!variant.setting.empty()) set_key(config, std::string(variant.setting));
  for (const std::string& assignment : assignments) set_key(config, assignment);
  if (config.estimator != chosen) {
    throw configuration_error(fmt::format("--set estimator={}", to_string(config.estimator)),
                              fmt::format("the drives are to be fused by {}", estimator),
                              "choose with --estimator");
  }
  return config;
}

}  // namespace lanefuse
