// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/scene.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "simulation/scenario.hpp"

namespace lanefuse {
namespace {

/// The nominal scene once more, on the road that it is driven on here anyway.
constexpr const char* kNominalTwin = "nominal-curved";

constexpr std::array kCourses{RoadKind::gentle, RoadKind::curved, RoadKind::sharp};

RoadKind course_of(const DriveKey& key) {
  const auto found = std::find_if(kCourses.begin(), kCourses.end(),
                                  [&key](RoadKind course) { return key.road == to_string(course); });
  if (found == kCourses.end()) {
    throw configuration_error("--road", fmt::format("there is no '{}'", key.road));
  }
  return *found;
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names = built_in_scenario_names();
  std::erase(names, kNominalScene);
  std::erase(names, kNominalTwin);
  names.insert(names.begin(), kNominalScene);
  return names;
}

std::vector<BenchmarkScene> benchmark_scenes() {
  std::vector<BenchmarkScene> scenes;
  for (const std::string& name : scene_names()) {
    const auto course = built_in_scenario(name).road.course;
    scenes.push_back({name, to_string(course.value_or(RoadKind::gentle))});
    if (name == kNominalScene) scenes.push_back({name, to_string(RoadKind::curved)});
  }
  return scenes;
}

std::string scene_hash(const std::string& name) {
  return fmt::format("{:016x}", fnv1a(built_in_scenario_text(name)));
}

SimulationConfig simulation_of(const DriveKey& key) {
  SimulationConfig config;
  config.seed = key.seed;
  config.km = key.km;
  config.road = course_of(key);
  config.scenario = built_in_scenario(key.scene);
  config.noise = key.noise;
  return config;
}

}  // namespace lanefuse
