// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "simulation/drive_simulation.hpp"

namespace lanefuse {

/// `lanefuse simulate`: records a simulated drive with exact truth.
struct SimulateOptions {
  SimulationConfig simulation;
  std::string road;                 ///< the word for it; empty: as the scenario says, else gentle
  std::string scenario;             ///< a name or a file; empty: the nominal one
  std::filesystem::path map;        ///< of the road; empty: as the scenario says
  std::filesystem::path write_map;  ///< empty: the map is not written
  bool list_scenarios = false;
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int simulate(const SimulateOptions& options);

}  // namespace lanefuse
