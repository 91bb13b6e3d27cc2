// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluate_command.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/evaluate_judging.hpp"
#include "cli/evaluation_text.hpp"
#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "drawing/report.hpp"
#include "evaluation/evaluation_json.hpp"
#include "evaluation/true_frames.hpp"
#include "roadmap/map_files.hpp"
#include "roadmap/road_map.hpp"

namespace lanefuse {
namespace {

Moment picture(const Highlight& highlight, const LanesAndTruth& context) {
  const LaneEstimate& estimate = highlight.record.estimate;
  Moment moment{make_view(highlight.record, context), "", {}};
  moment.view.title = fmt::format("{:.1f} s", highlight.seconds);
  moment.caption = highlight.most_switched
                       ? "The moment with the most switched-off smoothing edges: a vehicle changed lane."
                       : fmt::format("Status {}, vehicles that bear witness: {}.", to_string(estimate.status),
                                     estimate.witnesses);
  const auto frame = frame_at(context.truth->frames, estimate.time);
  if (frame && context.truth->road) moment.world_from_vehicle = frame->world_from_vehicle;
  return moment;
}

Report make_report(const Judged& judged, const LanesAndTruth& context) {
  Report report{"Lanes of " + judged.result.drive.name, judged.result, {}, {}, judged.trace};
  if (context.sidecar) report.run = context.sidecar->figures;
  for (const Highlight& highlight : judged.highlights) report.moments.push_back(picture(highlight, context));
  return report;
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

/// The drive's truth, with the road that was asked for in it.
LanesAndTruth truth_for(const EvaluateOptions& options) {
  LanesAndTruth context = find_truth(options.lanes, options.drive);
  if (!context.truth) {
    throw configuration_error(options.lanes.string(),
                              "the drive that these lanes came from is not to be found",
                              "name it with --drive");
  }
  refuse_damage(context.drive, context.truth->report);
  if (context.truth->frames.empty()) {
    throw input_error(options.lanes.string(), "its drive holds no truth (/truth/frame)");
  }
  if (options.map) context.truth->road = true_road(read_map(*options.map));
  return context;
}

}  // namespace

int evaluate(const EvaluateOptions& options) {
  const auto report_file = report_path(options);
  const LanesReader lanes(options.lanes);
  const LanesAndTruth context = truth_for(options);
  if (report_file) check_output(*report_file, true, context.drive);
  if (report_file && options.map) check_output(*report_file, true, *options.map);
  Judged judged = judge_lanes(options, context);
  EvaluationResult& result = judged.result;
  result.drive = lanes.drive();
  result.drive.witness = lanes.run().witness;
  result.estimator = lanes.run().estimator;

  if (report_file) {
    write_text(*report_file, write_report(make_report(judged, context)));
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
