// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/run_command.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "cli/progress.hpp"
#include "cli/run_sidecar.hpp"
#include "cli/window_dump.hpp"
#include "core/error.hpp"
#include "core/percentile.hpp"
#include "peers/named_solver.hpp"
#include "pipeline/graph_estimator.hpp"
#include "pipeline/perception.hpp"
#include "recording/drive_reader.hpp"
#include "recording/lanes_writer.hpp"

namespace lanefuse {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Wall-clock times of a run; the only place where a clock is read.
class Stopwatch {
 public:
  void begin_cycle() { cycle_begin_ = stage_begin_ = Clock::now(); }
  void end_stage(Stage stage) {
    stages_[static_cast<std::size_t>(stage)].push_back(milliseconds_since(stage_begin_));
    stage_begin_ = Clock::now();
  }
  void end_cycle() { cycles_.push_back(milliseconds_since(cycle_begin_)); }

  [[nodiscard]] const std::vector<double>& cycles() const { return cycles_; }
  [[nodiscard]] const std::vector<double>& stage(Stage stage) const {
    return stages_[static_cast<std::size_t>(stage)];
  }

 private:
  Clock::time_point cycle_begin_;
  Clock::time_point stage_begin_;
  std::array<std::vector<double>, kStageCount> stages_;
  std::vector<double> cycles_;
};

/// How many images came, and how many of them could not be believed.
struct ImageTotals {
  std::uint64_t seen = 0;
  std::map<std::string, std::uint64_t> faults;

  void add(std::span<const CameraView> views) {
    seen += views.size();
    for (const CameraView& view : views) {
      if (view.fault != ImageFault::none) ++faults[to_string(view.fault)];
    }
  }
};

/// What a run came to.
struct RunTotals {
  std::uint64_t cycles = 0;
  std::optional<Time> first;
  Time last{};
  InputAccounting inputs;
  ImageTotals images;
  GraphSize graph;
  std::optional<double> first_rejection;  ///< [s] since the first cycle

  void add(const LaneEstimate& estimate, const DebugView& debug) {
    ++cycles;
    if (!first) first = estimate.time;
    last = estimate.time;
    inputs += estimate.inputs;
    if (!first_rejection && estimate.inputs.rejected > 0) first_rejection = duration();
    graph.poses = std::max(graph.poses, debug.graph.poses);
    graph.features = std::max(graph.features, debug.graph.features);
    graph.edges = std::max(graph.edges, debug.graph.edges);
  }
  [[nodiscard]] double duration() const { return first ? to_seconds(last - *first) : 0; }
};

PerceptionConfig configure(const RunOptions& options, WitnessRule recorded) {
  PerceptionConfig config = default_config(recorded);
  if (options.config) config = load_config(*options.config, config);
  for (const std::string& assignment : options.assignments) set_key(config, assignment);
  if (options.estimator) set_key(config, fmt::format("estimator={}", *options.estimator));
  return config;
}

/// What looks into the graph, or solves it, is refused where there is none.
void demand_graph(const RunOptions& options, const PerceptionConfig& config) {
  if (config.estimator == EstimatorKind::graph) return;
  const char* given = options.graph_folder ? "--dump-graphs" : "--solver";
  if (!options.graph_folder && options.solver == "lanefuse") return;
  throw configuration_error(given, fmt::format("estimator {} has no graph", to_string(config.estimator)),
                            "leave it out, or choose --estimator graph");
}

/// Lets the paper's estimator be solved by another solver, and its windows be kept.
void set_up_graph(const RunOptions& options, LaneEstimator& estimator, std::optional<WindowDump>& windows) {
  auto* graph = dynamic_cast<GraphEstimator*>(&estimator);
  if (!graph) return;
  if (options.solver != "lanefuse") graph->use_solver(make_window_solver(make_solver(options.solver)));
  if (!options.graph_folder) return;
  windows.emplace(*options.graph_folder, options.force);
  graph->on_window([&windows](const WindowGraph& window) { windows->write(window); });
}

void print_json(const RunTotals& totals, const Stopwatch& watch, const PerceptionConfig& config) {
  nlohmann::ordered_json stages;
  for (int s = 0; s < kStageCount; ++s)
    stages[to_string(static_cast<Stage>(s))] = {
        {"p50", percentile(watch.stage(static_cast<Stage>(s)), 0.5)},
        {"p99", percentile(watch.stage(static_cast<Stage>(s)), 0.99)}};
  nlohmann::ordered_json json{{"cycles", totals.cycles},
                              {"duration_s", totals.duration()},
                              {"cycle_ms",
                               {{"p50", percentile(watch.cycles(), 0.5)},
                                {"p99", percentile(watch.cycles(), 0.99)},
                                {"max", percentile(watch.cycles(), 1)}}},
                              {"stage_ms", stages},
                              {"inputs",
                               {{"used", totals.inputs.used},
                                {"rejected", totals.inputs.rejected},
                                {"dropped", totals.inputs.dropped}}},
                              {"estimator", to_string(config.estimator)},
                              {"witness", to_string(config.sources.objects.witness.rule)},
                              {"configuration_hash", fingerprint(config)}};
  if (config.estimator == EstimatorKind::graph) {
    json["graph"] = {
        {"poses", totals.graph.poses}, {"features", totals.graph.features}, {"edges", totals.graph.edges}};
  }
  if (totals.images.seen > 0) {
    json["images"] = {{"seen", totals.images.seen}, {"faults", totals.images.faults}};
  }
  fmt::print("{}\n", json.dump());
}

void print_images(const ImageTotals& images) {
  if (images.seen == 0) return;
  fmt::print("images: {}", images.seen);
  for (const auto& [fault, count] : images.faults) fmt::print(", {} {}", count, fault);
  fmt::print("\n");
}

void print_text(const RunTotals& totals, const Stopwatch& watch, const PerceptionConfig& config,
                const RunOptions& options) {
  fmt::print("{} cycles over {:.1f} s by estimator {} -> {}\n", totals.cycles, totals.duration(),
             to_string(config.estimator), options.output.string());
  fmt::print("cycle p50 {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n", percentile(watch.cycles(), 0.5),
             percentile(watch.cycles(), 0.99), percentile(watch.cycles(), 1));
  fmt::print("inputs: {} used, {} rejected, {} dropped", totals.inputs.used, totals.inputs.rejected,
             totals.inputs.dropped);
  if (config.estimator == EstimatorKind::graph) {
    fmt::print("; largest graph: {} poses, {} features, {} edges", totals.graph.poses, totals.graph.features,
               totals.graph.edges);
  }
  fmt::print("\n");
  print_images(totals.images);
}

/// Runs all cycles that are due before `now`.
void advance(MultiLanePerception& perception, Time now, Stopwatch& watch, RunTotals& totals,
             LanesWriter& writer) {
  while (true) {
    watch.begin_cycle();
    const LaneEstimate* lanes = perception.advance(now);
    if (!lanes) return;
    watch.end_cycle();
    totals.add(*lanes, perception.debug());
    writer.write(*lanes, perception.debug(), perception.camera_views(), perception.objects());
    totals.images.add(perception.camera_views());
  }
}

void report_rejections(const RunOptions& options, const RunTotals& totals) {
  throw input_error(
      fmt::format("{}, cycle at {:.2f} s", options.drive.string(), totals.first_rejection.value_or(0)),
      fmt::format("holds impossible inputs: {} were rejected here and later", totals.inputs.rejected),
      "all others were fused; a number that is not finite or a covariance that is none comes from the "
      "recorder");
}

void report_damage(const RunOptions& options, const ReadReport& report) {
  throw input_error(
      options.drive.string(), "damaged: " + report.first_problem,
      fmt::format("what could be read was fused: {} chunks, {} records and {} messages were lost",
                  report.chunks_lost, report.records_lost, report.messages_refused));
}

}  // namespace

int run(const RunOptions& options) {
  if (options.print_config) {
    fmt::print("{}", to_yaml(configure(options, WitnessRule::radar_and_camera)));
    return 0;
  }
  check_output(options.output, options.force, options.drive);
  if (options.config) check_output(options.output, options.force, *options.config);
  check_output(sidecar_of(options.output), options.force, options.drive);
  DriveReader reader(options.drive);
  const PerceptionConfig config = configure(options, reader.info().witness);
  demand_graph(options, config);
  const WitnessRule witness = config.sources.objects.witness.rule;
  if (witness != WitnessRule::radar_and_camera) {
    fmt::print(stderr, "witness: {}, vehicles count without a camera's word\n", to_string(witness));
  }

  MultiLanePerception perception(config, reader.rig());
  std::optional<WindowDump> windows;
  set_up_graph(options, perception.estimator(), windows);
  LanesWriter writer(options.output, reader.info(),
                     {witness, to_string(config.estimator), fingerprint(config)});
  Stopwatch watch;
  RunTotals totals;
  perception.on_stage([&watch](Stage stage) { watch.end_stage(stage); });
  Progress progress("fusing");
  Measurement measurement;
  Time end{};
  while (reader.next(measurement)) {
    if (std::holds_alternative<GnssInsFix>(measurement)) continue;  // no input of lanes
    end = std::max(end, stamp_of(measurement).received_at);
    advance(perception, end, watch, totals, writer);
    perception.add(measurement);
    progress.show_seconds(totals.duration());
  }
  // One cycle more takes in, and accounts for, what came after the last.
  if (totals.cycles > 0) advance(perception, end + from_seconds(1 / config.cycle_hz), watch, totals, writer);
  if (totals.cycles == 0) {
    throw input_error(options.drive.string(), "holds less than one cycle of motion", "nothing was written");
  }
  writer.close();
  RunFigures figures{totals.duration(), totals.inputs, {}, watch.cycles()};
  if (config.estimator == EstimatorKind::graph) figures.largest_graph = totals.graph;
  write_sidecar(options.output, {options.drive, figures});

  if (options.json) {
    print_json(totals, watch, config);
  } else {
    print_text(totals, watch, config, options);
  }
  const ReadReport report = reader.report();
  if (!report.complete()) report_damage(options, report);
  if (totals.first_rejection) report_rejections(options, totals);
  return 0;
}

}  // namespace lanefuse
