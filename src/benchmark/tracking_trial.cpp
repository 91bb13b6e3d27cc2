// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/tracking_trial.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "benchmark/nearest_neighbour.hpp"
#include "evaluation/tracking_judge.hpp"
#include "evaluation/true_frames.hpp"
#include "pipeline/config.hpp"
#include "simulation/drive_simulation.hpp"
#include "sources/dead_reckoning.hpp"

namespace lanefuse {
namespace {

SimulationConfig simulated(const TrackingTrial& trial) {
  SimulationConfig config;
  config.seed = trial.seed;
  config.km = trial.km;
  config.road = trial.road;
  config.serial_camera = false;
  config.high_resolution_camera = false;
  config.detections = true;
  config.guard_rail_mirrors = trial.guard_rail_mirrors;
  return config;
}

/// Judges two trackers by one truth, once it has come: tracks are of times between its frames.
class TrialJudge {
 public:
  void add(const std::vector<TrueFrame>& frames) {
    if (frames.empty()) return;
    frames_.insert(frames_.end(), frames.begin(), frames.end());
    while (judged_ < waiting_.size() && waiting_[judged_].time <= frames_.back().time)
      judge(waiting_[judged_++]);
    waiting_.erase(waiting_.begin(),
                   waiting_.begin() + static_cast<std::ptrdiff_t>(std::exchange(judged_, 0)));
    // Cycles wait for frames, never the other way round: what is long past is not asked for again.
    constexpr std::size_t kKept = 128;
    if (frames_.size() >= 2 * kKept) frames_.erase(frames_.begin(), frames_.end() - kKept);
  }
  void add(Time time, std::span<const TrackedObject> fused, std::vector<TrackedObject> nearest_neighbour) {
    waiting_.push_back({time, {fused.begin(), fused.end()}, std::move(nearest_neighbour)});
  }
  [[nodiscard]] TrackingTrialFigures figures() const {
    return {fused_.figures(), nearest_neighbour_.figures()};
  }

 private:
  struct Cycle {
    Time time{};
    std::vector<TrackedObject> fused;
    std::vector<TrackedObject> nearest_neighbour;
  };
  void judge(const Cycle& cycle) {
    const auto frame = frame_at(frames_, cycle.time);
    if (!frame) return;
    fused_.add(*frame, cycle.fused);
    nearest_neighbour_.add(*frame, cycle.nearest_neighbour);
  }

  std::vector<TrueFrame> frames_;
  std::vector<Cycle> waiting_;
  std::size_t judged_ = 0;
  TrackingJudge fused_{TrackingJudgeConfig{}};
  TrackingJudge nearest_neighbour_{TrackingJudgeConfig{}};
};

/// What the pipeline does in a cycle as far as objects go, for two trackers at once.
class TrialDrive {
 public:
  TrialDrive(const TrackingTrial& trial, Rig rig)
      : rig_(std::move(rig)),
        dead_reckoning_(settings_.sources.odometry),
        source_(trial.objects),
        baseline_(rig_) {}

  /// Takes measurements in the order of receiving, and runs the cycles that are due between them.
  void add(std::vector<Measurement>& measurements, TrialJudge& judge) {
    for (Measurement& measurement : measurements) {
      const Time received = stamp_of(measurement).received_at;
      // On whole periods, as in the pipeline.
      if (!next_cycle_) next_cycle_ = Time{received.time_since_epoch() / period_ * period_} + period_;
      for (; received > *next_cycle_; *next_cycle_ += period_) run_cycle(*next_cycle_, judge);
      if (!implausible(measurement)) pending_.push_back(std::move(measurement));
    }
  }

 private:
  void run_cycle(Time now, TrialJudge& judge) {
    const auto key = [](const Measurement& one) {
      const Stamp& stamp = stamp_of(one);
      return std::tuple(stamp.measured_at, one.index(), stamp.sensor_id);
    };
    std::stable_sort(pending_.begin(), pending_.end(),
                     [&key](const Measurement& a, const Measurement& b) { return key(a) < key(b); });
    for (const Measurement& measurement : pending_)
      if (const auto* motion = std::get_if<VehicleMotion>(&measurement)) dead_reckoning_.add(*motion);
    const auto motion = dead_reckoning_.samples();
    const SourceContext context{rig_, motion, {}};
    for (const Measurement& measurement : pending_) {
      if (is_late(measurement, motion)) continue;
      source_.add(measurement, context);
      baseline_.add(measurement, motion);
    }
    pending_.clear();
    sets_.clear();
    source_.collect(now, context, sets_);
    judge.add(now, source_.objects(), baseline_.objects(now, motion));
  }

  [[nodiscard]] bool is_late(const Measurement& measurement, std::span<const MotionSample> motion) const {
    const Duration window = from_seconds(settings_.reorder_window_s);
    return !motion.empty() && motion.back().time - stamp_of(measurement).measured_at > window;
  }

  const PerceptionConfig settings_;
  const Rig rig_;
  const Duration period_ = from_seconds(1 / settings_.cycle_hz);
  DeadReckoning dead_reckoning_;
  ObjectSource source_;
  NearestNeighbour baseline_;
  std::vector<Measurement> pending_;
  std::vector<FeatureSet> sets_;
  std::optional<Time> next_cycle_;
};

}  // namespace

TrackingTrialFigures& TrackingTrialFigures::operator+=(const TrackingTrialFigures& other) {
  fused += other.fused;
  nearest_neighbour += other.nearest_neighbour;
  return *this;
}

std::vector<TrackingTrial> cut_trial(const TrackingTrial& whole) {
  constexpr std::uint64_t kSeedStep = 10'000;  // as many seeds as can be asked for do not meet
  std::vector<TrackingTrial> pieces;
  for (double left = whole.km; left > 1e-6; left -= kTrialKm) {
    TrackingTrial piece = whole;
    piece.seed = whole.seed + kSeedStep * pieces.size();
    piece.km = std::min(left, kTrialKm);
    pieces.push_back(piece);
  }
  return pieces;
}

TrackingTrialFigures run_trial(const TrackingTrial& trial, const std::function<void(double)>& progress) {
  DriveSimulation simulation(simulated(trial), nominal_preset());
  TrialDrive drive(trial, simulation.rig());
  TrialJudge judge;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  while (simulation.step(measurements, truth)) {
    judge.add(truth);
    drive.add(measurements, judge);
    if (!truth.empty()) progress(simulation.progress());
  }
  return judge.figures();
}

}  // namespace lanefuse
