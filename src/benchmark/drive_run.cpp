// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/drive_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "benchmark/judged_cycles.hpp"
#include "benchmark/scene.hpp"
#include "benchmark/variant.hpp"
#include "core/percentile.hpp"
#include "evaluation/evaluation_json.hpp"
#include "evaluation/serial_camera_baseline.hpp"
#include "pipeline/perception.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

SimulationConfig simulated(const DriveKey& key) {
  SimulationConfig config = simulation_of(key);
  find_variant(key.variant).leave_out(config);
  return config;
}

/// The survey that the paper's own truth came from, one a drive.
std::optional<SurveyedTruthConfig> survey_of(const DriveKey& key) {
  if (key.truth != "surveyed") return std::nullopt;
  SurveyedTruthConfig survey;
  survey.seed = key.seed;
  return survey;
}

/// Seconds spent, by what they were spent on.
class Times {
 public:
  explicit Times(const WallClock& clock) : clock_(clock), begin_(now()) {}

  /// Does `work` and adds what it took to `sum`.
  template <typename Work>
  auto spend(double& sum, Work&& work) {
    const double begin = now();
    auto result = work();
    sum += now() - begin;
    return result;
  }
  [[nodiscard]] double now() const { return clock_ ? clock_() : 0; }

  void write(Json& line) {
    if (!clock_) return;
    line["cycle_ms"] = {{"p50", percentile(cycle_ms, 0.5)},
                        {"p99", percentile(cycle_ms, 0.99)},
                        {"max", percentile(cycle_ms, 1)}};
    line["stage_s"] = {{"simulate", simulating}, {"fuse", fusing}, {"evaluate", judging}};
    line["wall_s"] = now() - begin_;
  }

  double simulating = 0;
  double fusing = 0;
  double judging = 0;
  std::vector<double> cycle_ms;

 private:
  const WallClock& clock_;
  double begin_;
};

/// A drive that is simulated, fused and judged side by side.
class DriveRun {
 public:
  DriveRun(const DriveJob& job, const WallClock& clock)
      : times_(clock),
        config_(configure(find_variant(job.key.variant), job.key.estimator, job.assignments)),
        simulation_(simulated(job.key), nominal_preset()),
        road_(simulation_.road()),
        perception_(config_, simulation_.rig()),
        judged_(road_, survey_of(job.key)) {}

  Json run(const std::function<void(double)>& progress) {
    while (times_.spend(times_.simulating, [this] { return simulation_.step(measurements_, truth_); })) {
      times_.spend(times_.judging, [this] { return judged_.add(truth_), true; });
      for (const Measurement& measurement : measurements_) take(measurement);
      if (!truth_.empty()) progress(simulation_.progress());
    }
    // One cycle more takes in, and accounts for, what came after the last.
    advance(received_ + from_seconds(1 / config_.cycle_hz));
    return result();
  }

 private:
  void take(const Measurement& measurement) {
    received_ = std::max(received_, stamp_of(measurement).received_at);
    advance(received_);
    times_.spend(times_.fusing, [&] { return perception_.add(measurement), true; });
    serial_camera_.add(measurement);
  }

  void advance(Time now) {
    while (true) {
      double seconds = 0;
      const LaneEstimate* lanes = times_.spend(seconds, [&] { return perception_.advance(now); });
      if (!lanes) return;
      times_.fusing += seconds;
      times_.cycle_ms.push_back(1000 * seconds);
      inputs_ += lanes->inputs;
      const GraphSize& graph = perception_.debug().graph;
      largest_.features = std::max(largest_.features, graph.features);
      largest_.edges = std::max(largest_.edges, graph.edges);
      judged_.add(*lanes, serial_camera_.at(lanes->time), perception_.objects());
    }
  }

  Json result() {
    EvaluationResult evaluation = times_.spend(times_.judging, [this] { return judged_.finish(); });
    Json line = to_json(evaluation);
    for (const char* in_head : {"truth", "drive", "preset_hash"}) line.erase(in_head);
    line["witness"] = to_string(config_.sources.objects.witness.rule);
    line["inputs"] = {{"used", inputs_.used}, {"rejected", inputs_.rejected}, {"dropped", inputs_.dropped}};
    if (config_.estimator == EstimatorKind::graph) {
      line["graph"] = {{"features", largest_.features}, {"edges", largest_.edges}};
    }
    times_.write(line);
    return line;
  }

  Times times_;
  PerceptionConfig config_;
  DriveSimulation simulation_;
  TrueRoad road_;
  MultiLanePerception perception_;
  SerialCameraBaseline serial_camera_;
  JudgedCycles judged_;
  std::vector<Measurement> measurements_;
  std::vector<TrueFrame> truth_;
  Time received_{};
  InputAccounting inputs_;
  GraphSize largest_;
};

}  // namespace

Provenance provenance_of(const DriveJob& job, const std::string& version) {
  const PerceptionConfig config =
      configure(find_variant(job.key.variant), job.key.estimator, job.assignments);
  return {version, nominal_preset().hash, scene_hash(job.key.scene), fingerprint(config)};
}

Json run_drive(const DriveJob& job, const WallClock& clock, const std::function<void(double)>& progress) {
  return DriveRun(job, clock).run(progress);
}

}  // namespace lanefuse
