// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/endurance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/perception.hpp"
#include "simulation/drive_simulation.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {

namespace {

/// By nearest rank; 0 for none. Sorts.
double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

/// Times of the cycles of a stretch. Its memory is set aside once, so that it does not grow beside what is
/// measured.
class StretchLog {
 public:
  explicit StretchLog(double most_cycles) {
    wall_.reserve(static_cast<std::size_t>(most_cycles));
    cpu_.reserve(static_cast<std::size_t>(most_cycles));
  }

  void add(double wall_ms, double cpu_ms, const LaneEstimate& estimate, const GraphSize& graph) {
    wall_.push_back(wall_ms);
    cpu_.push_back(cpu_ms);
    stretch_.not_ok += estimate.status == EstimateStatus::ok ? 0 : 1;
    stretch_.inputs += estimate.inputs;
    GraphSize& largest = stretch_.largest;
    largest.poses = std::max(largest.poses, graph.poses);
    largest.features = std::max(largest.features, graph.features);
    largest.edges = std::max(largest.edges, graph.edges);
  }

  EnduranceStretch finish(double end_hours, double resident_mb) {
    EnduranceStretch done = std::exchange(stretch_, {});
    done.end_hours = end_hours;
    done.cycles = wall_.size();
    done.p50_ms = percentile(wall_, 0.5);
    done.p99_ms = percentile(wall_, 0.99);
    done.max_ms = percentile(wall_, 1);
    done.cpu_p99_ms = percentile(cpu_, 0.99);
    done.cpu_max_ms = percentile(cpu_, 1);
    done.resident_mb = resident_mb;
    wall_.clear();
    cpu_.clear();
    return done;
  }

  [[nodiscard]] bool empty() const { return wall_.empty(); }

 private:
  std::vector<double> wall_, cpu_;
  EnduranceStretch stretch_;
};

SimulationConfig simulation_of(const EnduranceConfig& config) {
  SimulationConfig simulation;
  simulation.seed = config.seed;
  simulation.road = config.road;
  simulation.scenario = config.scenario;
  simulation.detections = config.detections;
  // At its own wish the ego car goes so far; others only ever make it slower.
  simulation.km = 3.6 * nominal_preset().ego.speed * config.hours;
  return simulation;
}

}  // namespace

void drive_endurance(const EnduranceConfig& config, double stretch_hours, const MachineGauges& gauges,
                     std::unique_ptr<WindowSolver> solver,
                     const std::function<void(const EnduranceStretch&)>& take) {
  DriveSimulation simulation(simulation_of(config), nominal_preset());
  PerceptionConfig perception_config = default_config(WitnessRule::radar_and_camera);
  perception_config.cycle_hz = config.cycle_hz;
  MultiLanePerception perception(perception_config, simulation.rig());
  // The only estimator there is.
  if (solver) dynamic_cast<GraphEstimator&>(perception.estimator()).use_solver(std::move(solver));
  StretchLog log(stretch_hours * 3600 * config.cycle_hz + 2);
  std::optional<Time> start;
  std::uint64_t stretches = 0;
  double hours = 0;
  const auto run_cycles = [&](Time now) {
    while (hours < config.hours) {
      const double wall = gauges.wall_ms();
      const double cpu = gauges.cpu_ms();
      const LaneEstimate* lanes = perception.advance(now);
      if (!lanes) return;
      log.add(gauges.wall_ms() - wall, gauges.cpu_ms() - cpu, *lanes, perception.debug().graph);
      if (!start) start = lanes->time;
      hours = to_seconds(lanes->time - *start) / 3600;
      if (hours < static_cast<double>(stretches + 1) * stretch_hours) continue;
      ++stretches;
      take(log.finish(hours, gauges.resident_mb()));
    }
  };
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  for (bool more = true; more && hours < config.hours;) {
    more = simulation.step(measurements, truth);
    for (const Measurement& measurement : measurements) {
      run_cycles(stamp_of(measurement).received_at);
      perception.add(measurement);
    }
  }
  if (!log.empty()) take(log.finish(hours, gauges.resident_mb()));
}

}  // namespace lanefuse
