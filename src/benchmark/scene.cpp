// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/scene.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {

std::vector<BenchmarkScene> benchmark_scenes() {
  return {{kNominalScene, to_string(RoadKind::gentle)}, {kNominalScene, to_string(RoadKind::curved)}};
}

SimulationConfig simulation_of(const DriveKey& key) {
  if (key.scene != kNominalScene) {
    throw configuration_error("--scene", fmt::format("there is no '{}'", key.scene));
  }
  SimulationConfig config;
  config.seed = key.seed;
  config.km = key.km;
  config.road = key.road == to_string(RoadKind::curved) ? RoadKind::curved : RoadKind::gentle;
  return config;
}

}  // namespace lanefuse
