// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/lane_estimate.hpp"
#include "pipeline/config.hpp"
#include "pipeline/graph_estimator.hpp"
#include "simulation/road.hpp"
#include "simulation/scenario.hpp"

namespace lanefuse {

/// One long simulated drive, fused as it is simulated; nothing of it is stored.
struct EnduranceConfig {
  std::uint64_t seed = 1;
  double hours = 24;     ///< of the drive, > 0
  double cycle_hz = 25;  ///< [Hz]
  RoadKind road = RoadKind::gentle;
  Scenario scenario;
  bool detections = false;  ///< raw detections instead of object lists
  EstimatorKind estimator = EstimatorKind::graph;
};

/// What the machine says; handed in, as no library of ours asks it.
struct MachineGauges {
  std::function<double()> wall_ms;      ///< since whenever
  std::function<double()> cpu_ms;       ///< that this thread has worked: others' work does not count
  std::function<double()> resident_mb;  ///< memory of this process
};

/// A stretch of the drive, with one of the solvers.
struct EnduranceStretch {
  std::size_t solver = 0;  ///< which of those that were given
  double end_hours = 0;    ///< of the drive
  std::uint64_t cycles = 0;
  std::uint64_t not_ok = 0;                   ///< cycles whose estimate was not OK
  double p50_ms = 0, p99_ms = 0, max_ms = 0;  ///< a cycle, wall clock
  double cpu_p99_ms = 0, cpu_max_ms = 0;      ///< a cycle, processor time
  double resident_mb = 0;                     ///< at its end
  GraphSize largest;
  InputAccounting inputs;
};

/// Drives, and hands over each stretch of `stretch_hours` when it is done, once a solver. All solvers (null:
/// ours, and what every estimator but the graph must have) have a perception of their own, which gets the
/// same measurements; they take turns cycle by cycle, so that whatever else the machine does falls on all of
/// them.
void drive_endurance(const EnduranceConfig& config, double stretch_hours, const MachineGauges& gauges,
                     std::vector<std::unique_ptr<WindowSolver>> solvers,
                     const std::function<void(const EnduranceStretch&)>& take);

}  // namespace lanefuse
