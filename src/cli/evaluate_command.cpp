// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluate_command.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/evaluation_text.hpp"
#include "cli/lanes_and_truth.hpp"
#include "cli/output_file.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "drawing/report.hpp"
#include "evaluation/ego_path.hpp"
#include "evaluation/evaluation_json.hpp"
#include "evaluation/exact_truth.hpp"
#include "evaluation/true_frames.hpp"

namespace lanefuse {
namespace {

/// The cycles that the report shows: spread over the drive, and the one with the most switched-off edges.
struct Highlights {
  std::vector<Time> times;
  Time most_switched{};
  std::size_t most_switched_count = 0;

  void add(const LaneRecord& record) {
    times.push_back(record.estimate.time);
    const auto off =
        static_cast<std::size_t>(std::count_if(record.debug.switches.begin(), record.debug.switches.end(),
                                               [](const SwitchState& s) { return s.value < 0.5; }));
    if (off <= most_switched_count) return;
    most_switched_count = off;
    most_switched = record.estimate.time;
  }

  [[nodiscard]] std::vector<Time> chosen() const {
    std::vector<Time> moments;
    for (const double share : {0.1, 0.5, 0.9}) {
      if (!times.empty())
        moments.push_back(times[static_cast<std::size_t>(share * static_cast<double>(times.size()))]);
    }
    if (most_switched_count > 0) moments.push_back(most_switched);
    std::sort(moments.begin(), moments.end());
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
    return moments;
  }
};

void refuse_damage(const std::filesystem::path& file, const ReadReport& report) {
  if (!report.complete()) throw input_error(file.string(), "damaged: " + report.first_problem);
}

template <typename Judge>
Highlights judge_all(const EvaluateOptions& options, Judge&& judge) {
  Highlights highlights;
  Progress progress("evaluating");
  LanesReader reader(options.lanes);
  LaneRecord record;
  while (reader.next(record)) {
    highlights.add(record);
    judge(record.estimate);
    progress.show_seconds(to_seconds(record.estimate.time - highlights.times.front()));
  }
  refuse_damage(options.lanes, reader.report());
  if (highlights.times.empty()) throw input_error(options.lanes.string(), "holds no cycle");
  return highlights;
}

EvaluationResult judge_exact(const EvaluateOptions& options, const DriveTruth& truth,
                             Highlights& highlights) {
  if (!truth.road) {
    throw input_error(options.lanes.string(), "its drive has no exact truth (/truth/road)",
                      "try --truth ego-path");
  }
  ExactTruthEvaluation evaluation(*truth.road);
  highlights = judge_all(options, [&](const LaneEstimate& estimate) {
    const auto frame = frame_at(truth.frames, estimate.time);
    frame ? evaluation.add(estimate, *frame) : evaluation.add_without_truth(estimate);
  });
  return evaluation.result();
}

EvaluationResult judge_ego_path(const EvaluateOptions& options, const DriveTruth& truth,
                                Highlights& highlights) {
  EgoPathEvaluation evaluation(truth.frames);
  highlights = judge_all(
      options, [&](const LaneEstimate& estimate) { evaluation.add(estimate, estimate.witnesses > 0); });
  return evaluation.result();
}

std::vector<Moment> picture(const EvaluateOptions& options, const LanesAndTruth& context,
                            const Highlights& highlights) {
  std::vector<Moment> moments;
  const std::vector<Time> chosen = highlights.chosen();
  LanesReader reader(options.lanes);
  LaneRecord record;
  while (moments.size() < chosen.size() && reader.next(record)) {
    if (record.estimate.time != chosen[moments.size()]) continue;
    const double seconds = to_seconds(record.estimate.time - highlights.times.front());
    Moment moment{make_view(record, context), ""};
    moment.view.title = fmt::format("{:.1f} s", seconds);
    moment.caption = record.estimate.time == highlights.most_switched && highlights.most_switched_count > 0
                         ? "The moment with the most switched-off smoothing edges: a vehicle changed lane."
                         : fmt::format("Status {}, vehicles that bear witness: {}.",
                                       to_string(record.estimate.status), record.estimate.witnesses);
    moments.push_back(std::move(moment));
  }
  return moments;
}

/// A report that was asked for by name must not be there; one at its usual place is then kept, and that is
/// said.
std::optional<std::filesystem::path> report_path(const EvaluateOptions& options) {
  if (options.report) {
    check_output(*options.report, options.force, options.lanes);
    return options.report;
  }
  const auto usual = std::filesystem::absolute(options.lanes).parent_path() / "report.html";
  if (options.force || !std::filesystem::exists(usual)) return usual;
  fmt::print(stderr, "{} is there already and was kept; --force overwrites it, --report names another\n",
             usual.string());
  return std::nullopt;
}

}  // namespace

int evaluate(const EvaluateOptions& options) {
  const auto report_file = report_path(options);
  const LanesReader lanes(options.lanes);
  const LanesAndTruth context = find_truth(options.lanes, options.drive);
  if (!context.truth) {
    throw configuration_error(options.lanes.string(),
                              "the drive that these lanes came from is not to be found",
                              "name it with --drive");
  }
  if (report_file) check_output(*report_file, true, context.drive);
  refuse_damage(context.drive, context.truth->report);
  if (context.truth->frames.empty()) {
    throw input_error(options.lanes.string(), "its drive holds no truth (/truth/frame)");
  }
  Highlights highlights;
  EvaluationResult result = options.truth == "exact" ? judge_exact(options, *context.truth, highlights)
                                                     : judge_ego_path(options, *context.truth, highlights);
  result.drive = lanes.drive();
  result.drive.witness = lanes.run().witness;

  if (report_file) {
    Report report{"Lanes of " + result.drive.name, result, {}, picture(options, context, highlights)};
    if (context.sidecar) report.run = context.sidecar->figures;
    write_text(*report_file, write_report(report));
    fmt::print(stderr, "report: {}\n", report_file->string());
  }
  if (options.json) {
    fmt::print("{}\n", to_json(result).dump());
  } else {
    fmt::print("{}", to_table(result));
  }
  return 0;
}

}  // namespace lanefuse
