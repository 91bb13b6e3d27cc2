// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/endurance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/percentile.hpp"
#include "pipeline/perception.hpp"
#include "simulation/drive_simulation.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {

namespace {

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

/// One solver's perception of the drive.
class Contender {
 public:
  Contender(const EnduranceConfig& config, double stretch_hours, const Rig& rig,
            std::unique_ptr<WindowSolver> solver)
      : perception_(perception_config(config), rig),
        log_(stretch_hours * 3600 * config.cycle_hz + 2),
        stretch_hours_(stretch_hours) {
    // Only graphs have solvers: drive_endurance() takes none for another estimator.
    if (solver) dynamic_cast<GraphEstimator&>(perception_.estimator()).use_solver(std::move(solver));
  }

  void add(const Measurement& measurement) { perception_.add(measurement); }

  /// Runs the next cycle if it is due; false if none is.
  bool advance(Time now, const MachineGauges& gauges) {
    const double wall = gauges.wall_ms();
    const double cpu = gauges.cpu_ms();
    const LaneEstimate* lanes = perception_.advance(now);
    if (!lanes) return false;
    log_.add(gauges.wall_ms() - wall, gauges.cpu_ms() - cpu, *lanes, perception_.debug().graph);
    if (!start_) start_ = lanes->time;
    hours_ = to_seconds(lanes->time - *start_) / 3600;
    return true;
  }

  [[nodiscard]] double hours() const { return hours_; }  ///< driven so far
  [[nodiscard]] bool has_stretch() const {
    return hours_ >= static_cast<double>(stretches_ + 1) * stretch_hours_;
  }
  [[nodiscard]] bool has_rest() const { return !log_.empty(); }
  EnduranceStretch finish(const MachineGauges& gauges) {
    ++stretches_;
    return log_.finish(hours_, gauges.resident_mb());
  }

 private:
  static PerceptionConfig perception_config(const EnduranceConfig& config) {
    PerceptionConfig result = default_config(WitnessRule::radar_and_camera);
    result.cycle_hz = config.cycle_hz;
    result.estimator = config.estimator;
    return result;
  }

  MultiLanePerception perception_;
  StretchLog log_;
  double stretch_hours_;
  std::optional<Time> start_;
  std::uint64_t stretches_ = 0;
  double hours_ = 0;
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
                     std::vector<std::unique_ptr<WindowSolver>> solvers,
                     const std::function<void(const EnduranceStretch&)>& take) {
  assert(config.estimator == EstimatorKind::graph ||
         std::none_of(solvers.begin(), solvers.end(), [](const auto& solver) { return solver != nullptr; }));
  DriveSimulation simulation(simulation_of(config), nominal_preset());
  std::vector<std::unique_ptr<Contender>> contenders;
  for (auto& solver : solvers)
    contenders.push_back(
        std::make_unique<Contender>(config, stretch_hours, simulation.rig(), std::move(solver)));
  const auto hand_over = [&](std::size_t which) {
    EnduranceStretch stretch = contenders[which]->finish(gauges);
    stretch.solver = which;
    take(stretch);
  };
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  for (bool more = true; more && contenders.front()->hours() < config.hours;) {
    more = simulation.step(measurements, truth);
    for (const Measurement& measurement : measurements) {
      for (bool ran = true; ran;) {
        ran = false;
        for (const auto& contender : contenders)
          ran |= contender->advance(stamp_of(measurement).received_at, gauges);
      }
      for (std::size_t c = 0; c < contenders.size(); ++c) {
        if (contenders[c]->has_stretch()) hand_over(c);
        contenders[c]->add(measurement);
      }
    }
  }
  for (std::size_t c = 0; c < contenders.size(); ++c) {
    if (contenders[c]->has_rest()) hand_over(c);
  }
}

}  // namespace lanefuse
