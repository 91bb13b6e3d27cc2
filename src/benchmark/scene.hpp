// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "benchmark/drive_key.hpp"
#include "simulation/drive_simulation.hpp"

namespace lanefuse {

/// What happens on a drive, and on which road.
struct BenchmarkScene {
  std::string name;
  std::string road;
};

inline constexpr const char* kNominalScene = "nominal";

/// The built-in scenarios, the nominal one first.
std::vector<std::string> scene_names();

/// Each of them on its own road, the gentle one where it asks for none; the nominal one on the curved road,
/// too.
std::vector<BenchmarkScene> benchmark_scenes();

/// Names what a scene is made of: another scenario file, another hash.
std::string scene_hash(const std::string& name);

/// The simulated drive of that name, all sensors on. Throws a configuration Error where there is no such
/// scene.
SimulationConfig simulation_of(const DriveKey& key);

}  // namespace lanefuse
