// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lanefuse {

/// `lanefuse bench endurance`.
struct EnduranceOptions {
  double hours = 24;
  double cycle_hz = 25;
  double report_minutes = 60;  ///< of the drive, between lines
  std::uint64_t seed = 1;
  std::string scenario = "nominal";
  std::vector<std::string> beside;  ///< other solvers of the graph that get the same drive: see make_solver()
  std::string estimator = "graph";
  bool detections = false;
  bool json = false;
  bool force = false;
};

/// Simulates and fuses a long drive in this process, stores nothing, and prints for each stretch what a cycle
/// took and how much memory is held; with other solvers beside it, how many times as long theirs take.
int bench_endurance(const EnduranceOptions& options);

}  // namespace lanefuse
