// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// What a cycle costs, from measurements to lanes, on a simulated drive; and whether memory stays flat on one
// ten times as long. The time of an iteration is that of all cycles of its drive, without the simulation.
#include <algorithm>
#include <chrono>
#include <sys/resource.h>
#include <vector>

#include <benchmark/benchmark.h>

#include "pipeline/perception.hpp"
#include "simulation/drive_simulation.hpp"

namespace lanefuse {
namespace {

using Clock = std::chrono::steady_clock;

struct DriveCost {
  std::vector<double> cycle_ms;
  GraphSize largest;

  /// Runs every cycle that is due before `now`.
  void advance(MultiLanePerception& perception, Time now) {
    for (;;) {
      const Clock::time_point begin = Clock::now();
      if (!perception.advance(now)) return;
      cycle_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
      const GraphSize& graph = perception.debug().graph;
      largest.features = std::max(largest.features, graph.features);
      largest.edges = std::max(largest.edges, graph.edges);
    }
  }

  [[nodiscard]] double percentile(double share) const {
    std::vector<double> sorted = cycle_ms;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
};

/// Simulates and fuses side by side: no drive is ever held in memory.
DriveCost fuse_simulated_drive(double km) {
  DriveSimulation simulation({.seed = 1, .km = km}, nominal_preset());
  MultiLanePerception perception(default_config(WitnessRule::radar_and_camera), simulation.rig());
  DriveCost cost;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  for (bool more = true; more;) {
    more = simulation.step(measurements, truth);
    for (const Measurement& measurement : measurements) {
      cost.advance(perception, stamp_of(measurement).received_at);
      perception.add(measurement);
    }
  }
  return cost;
}

/// The most memory that this process ever held [MB]. It never falls: the short drive must come first.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void fuse_drive(benchmark::State& state) {
  DriveCost cost;
  for (auto _ : state) {
    cost = fuse_simulated_drive(static_cast<double>(state.range(0)));
    double seconds = 0;
    for (const double ms : cost.cycle_ms) seconds += ms / 1000;
    state.SetIterationTime(seconds);
  }
  state.counters["cycles"] = static_cast<double>(cost.cycle_ms.size());
  state.counters["p50_ms"] = cost.percentile(0.5);
  state.counters["p99_ms"] = cost.percentile(0.99);
  state.counters["features"] = cost.largest.features;
  state.counters["edges"] = cost.largest.edges;
  state.counters["peak_MB"] = peak_memory();
}

BENCHMARK(fuse_drive)
    ->ArgName("km")
    ->Arg(2)
    ->Arg(20)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lanefuse
