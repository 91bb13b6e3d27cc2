// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/variant.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "benchmark/estimator_choice.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr auto kNothing = [](SimulationConfig&) {};

constexpr auto kAny = std::nullopt;
constexpr EstimatorKind kGraph = EstimatorKind::graph;
constexpr EstimatorKind kRoad = EstimatorKind::road;

constexpr std::array<Variant, 17> kVariants{{
    {"full", "every source and every edge", kNothing, "", kAny},
    {"no-objects", "no other vehicles as witnesses", [](SimulationConfig& c) { c.objects = false; }, "",
     kAny},
    {"no-high-resolution-camera", "no marking features of the second camera",
     [](SimulationConfig& c) { c.high_resolution_camera = false; }, "", kAny},
    {"no-serial-camera", "no lanes of the serial camera",
     [](SimulationConfig& c) { c.serial_camera = false; }, "", kAny},
    {"no-width", "no edges across a lane (eq. 8)", kNothing, "fusion.width_edges=false", kGraph},
    {"no-smoothing", "no edges along a vehicle's trail (eq. 9)", kNothing, "fusion.smoothing_edges=false",
     kGraph},
    {"no-switches", "smoothing edges that cannot switch off", kNothing, "fusion.switchable=false", kGraph},
    {"no-yaw-bias", "cameras' mountings known exactly", kNothing,
     "road.camera.yaw.sigma_deg=1e-6 road.tracked_lane.yaw.sigma_deg=1e-6", kRoad},
    {"no-pitch", "a body that does not pitch", kNothing, "road.camera.pitch.sigma_deg=1e-6", kRoad},
    {"no-lean", "no error that a frame's lines share", kNothing, "road.camera.lean.sigma_deg=1e-6", kRoad},
    {"no-crests", "a flat road", kNothing, "road.camera.vertical_curvature=1e-9", kRoad},
    {"tracked-lane-believed", "the serial camera's covariance as it says", kNothing,
     "road.tracked_lane.inflation=1", kRoad},
    {"no-driver-bias", "drivers in the middle of their lanes", kNothing, "road.vehicles.driver_sigma=1e-6",
     kRoad},
    {"parallel-lines", "lines that keep their distance", kNothing, "road.course.offset_step=1e-6", kRoad},
    {"no-noise-scale", "sensors that err as assumed", kNothing, "road.adapt_noise=false", kRoad},
    {"no-range-order", "a frame given to lines at once, not from near to far", kNothing,
     "road.range_order=false", kRoad},
    {"no-switch", "vehicles that change lane believed all the while", kNothing,
     "road.vehicles.switchable=false", kRoad},
}};

/// No piece less, but other input: apart from the ablations, which are driven all together.
constexpr Variant kDetections{kDetectionsVariant,
                              "radars' and a camera's detections in place of the object list",
                              [](SimulationConfig& c) { c.detections = true; }, "", kAny};

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

bool has_piece(const Variant& variant, std::string_view estimator) {
  PerceptionConfig config;
  choose_estimator(config, estimator);
  return !variant.of || *variant.of == config.estimator;
}

void demand_piece(const Variant& variant, std::string_view estimator) {
  if (has_piece(variant, estimator)) return;
  std::vector<std::string> names = variant_names();
  std::erase_if(names, [&](const std::string& name) { return !has_piece(find_variant(name), estimator); });
  throw configuration_error("--variant",
                            fmt::format("'{}' takes nothing from the estimator {}", variant.name, estimator),
                            fmt::format("choose among {}", fmt::join(names, ", ")));
}

PerceptionConfig configure(const Variant& variant, std::string_view estimator,
                           std::span<const std::string> assignments) {
  PerceptionConfig config = default_config(WitnessRule::radar_and_camera);
  choose_estimator(config, estimator);
  const EstimatorKind chosen = config.estimator;
  demand_piece(variant, estimator);
  std::istringstream settings{std::string(variant.settings)};
  for (std::string setting; settings >> setting;) set_key(config, setting);
  for (const std::string& assignment : assignments) set_key(config, assignment);
  if (config.estimator != chosen) {
    throw configuration_error(fmt::format("--set estimator={}", to_string(config.estimator)),
                              fmt::format("the drives are to be fused by {}", estimator),
                              "choose with --estimator");
  }
  return config;
}

}  // namespace lanefuse
