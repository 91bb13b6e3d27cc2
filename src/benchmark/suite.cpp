// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/suite.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "benchmark/estimator_choice.hpp"
#include "benchmark/scene.hpp"
#include "benchmark/variant.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr const char* kAll = "all";

/// What a suite drives unless it is asked for something else.
struct Suite {
  const char* name;
  const char* scene;
  const char* road;
  const char* variant;
  double km;  ///< a drive
  const char* estimator;
};

const Suite kSuites[] = {
    {"nominal", kNominalScene, kAll, "full", 24, "graph"},
    {"scenes", kAll, kAll, "full", 4, "graph"},
    {"ablations", kNominalScene, "gentle", kAll, 24, "graph"},
    {"road-ablations", kNominalScene, "gentle", kAll, 24, "road"},
    {"coverage", kNominalScene, kAll, "full", 2, "graph"},
};

void demand_one_of(const char* option, const std::string& name, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw configuration_error(option, fmt::format("there is no '{}'", name),
                            fmt::format("choose among {}", fmt::join(names, ", ")));
}

const Suite& find_suite(const std::string& name) {
  demand_one_of("--suite", name, suite_names());
  return *std::find_if(std::begin(kSuites), std::end(kSuites),
                       [&name](const Suite& suite) { return name == suite.name; });
}

bool fits(const std::string& wanted, const std::string& name) { return wanted == kAll || wanted == name; }

/// A scene that is asked for by name is driven on whatever road it has.
std::vector<BenchmarkScene> scenes_of(const SuiteChoice& choice, const Suite& suite) {
  const std::string scene = choice.scene.value_or(suite.scene);
  const std::string road = choice.road.value_or(choice.scene ? kAll : suite.road);
  if (scene != kAll) demand_one_of("--scene", scene, scene_names());
  std::vector<BenchmarkScene> scenes = benchmark_scenes();
  std::erase_if(scenes, [&](const BenchmarkScene& s) { return !fits(scene, s.name); });
  std::erase_if(scenes, [&](const BenchmarkScene& s) { return !fits(road, s.road); });
  if (scenes.empty()) {
    throw configuration_error("--road", fmt::format("scene '{}' has no road '{}'", scene, road));
  }
  return scenes;
}

std::vector<std::string> variants_of(const SuiteChoice& choice, const Suite& suite) {
  const std::string variant = choice.variant.value_or(suite.variant);
  std::vector<std::string> names = variant_names();
  if (variant != kAll) names = {std::string(find_variant(variant).name)};
  const std::string detections(kDetectionsVariant);
  if (choice.detections && names.back() != detections) names.push_back(detections);
  return names;
}

/// Those that are asked for, each once.
std::vector<std::string> estimators_of(const SuiteChoice& choice, const Suite& suite) {
  if (choice.estimators.empty()) return {suite.estimator};
  std::vector<std::string> estimators;
  for (const std::string& name : choice.estimators) {
    demand_one_of("--estimator", name, estimator_names());
    if (std::find(estimators.begin(), estimators.end(), name) == estimators.end()) estimators.push_back(name);
  }
  return estimators;
}

void demand_seed(bool holds, const std::string& text) {
  if (!holds) {
    throw configuration_error("--seeds", fmt::format("'{}' is no list of seeds", text),
                              fmt::format("write 1-6,9: at most {}, each once", kMostSeeds));
  }
}

std::uint64_t parse_seed(const std::string& number, const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), seed);
  demand_seed(error == std::errc{} && end == number.data() + number.size(), text);
  return seed;
}

}  // namespace

std::vector<std::string> suite_names() {
  std::vector<std::string> names;
  for (const Suite& suite : kSuites) names.emplace_back(suite.name);
  return names;
}

std::vector<DriveKey> drives_of(const SuiteChoice& choice) {
  const Suite& suite = find_suite(choice.suite);
  const std::vector<std::string> estimators = estimators_of(choice, suite);
  demand_one_of("--truth", choice.truth, {"exact", "surveyed"});
  const auto scenes = scenes_of(choice, suite);
  const auto variants = variants_of(choice, suite);
  const bool all = choice.variant.value_or(suite.variant) == kAll;
  const double km = choice.km.value_or(suite.km);
  std::vector<DriveKey> drives;
  for (const std::uint64_t seed : choice.seeds) {
    for (const BenchmarkScene& scene : scenes) {
      for (const std::string& variant : variants) {
        for (const std::string& estimator : estimators) {
          if (all && !has_piece(find_variant(variant), estimator)) continue;
          demand_piece(find_variant(variant), estimator);
          drives.push_back({scene.name, scene.road, seed, km, variant, estimator, choice.truth});
        }
      }
    }
  }
  for (DriveKey& drive : drives) drive.noise = choice.noise;
  return drives;
}

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  std::set<std::uint64_t> seen;
  std::stringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t dash = part.find('-');
    const std::uint64_t first = parse_seed(part.substr(0, dash), text);
    const std::uint64_t last = dash == std::string::npos ? first : parse_seed(part.substr(dash + 1), text);
    demand_seed(first <= last && last - first < kMostSeeds, text);
    for (std::uint64_t offset = 0; offset <= last - first; ++offset) {
      demand_seed(seen.insert(first + offset).second && seeds.size() < kMostSeeds, text);
      seeds.push_back(first + offset);
    }
  }
  demand_seed(!seeds.empty() && text.back() != ',', text);
  return seeds;
}

}  // namespace lanefuse
