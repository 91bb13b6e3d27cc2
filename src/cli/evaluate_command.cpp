// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluate_command.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/evaluate_judging.hpp"
#include "cli/evaluation_text.hpp"
#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "drawing/report.hpp"
#include "evaluation/evaluation_json.hpp"

namespace lanefuse {
namespace {

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
  Judged judged = judge_lanes(options, context);
  EvaluationResult& result = judged.result;
  result.drive = lanes.drive();
  result.drive.witness = lanes.run().witness;

  if (report_file) {
    Report report{"Lanes of " + result.drive.name, result, {}, picture(options, context, judged.highlights)};
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
