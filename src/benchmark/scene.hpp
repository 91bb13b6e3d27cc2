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

/// Every scene there is, the nominal ones first.
std::vector<BenchmarkScene> benchmark_scenes();

/// The simulated drive of that name, all sensors on. Throws a configuration Error where there is no such
/// scene.
SimulationConfig simulation_of(const DriveKey& key);

}  // namespace lanefuse
