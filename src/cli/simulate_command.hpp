// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "simulation/drive_simulation.hpp"

namespace lanefuse {

/// `lanefuse simulate`: records a simulated drive with exact truth.
struct SimulateOptions {
  SimulationConfig simulation;
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int simulate(const SimulateOptions& options);

}  // namespace lanefuse
