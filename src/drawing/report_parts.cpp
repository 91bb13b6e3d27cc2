// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/report_parts.hpp"

#include <numbers>

#include <fmt/format.h>

#include "core/percentile.hpp"
#include "drawing/chart.hpp"
#include "drawing/html.hpp"

namespace lanefuse {
namespace {

std::string witness_line(WitnessRule rule) {
  const bool papers = rule == WitnessRule::radar_and_camera;
  return fmt::format(
             R"(<p class="witness{}"><b>witness: {}</b> &#8211; {}</p>)", papers ? "" : " other",
             to_string(rule),
             papers
                 ? "a vehicle counts once a radar and a camera have verified it, as in the paper"
                 : "a vehicle counts once a radar has verified it; this drive has no camera, so the paper's "
                   "rule (radar and camera) could not be kept") +
         '\n';
}

/// A tile of the run's figures; `note` explains in small print.
std::string tile(const std::string& name, const std::string& value, const std::string& note = {}) {
  return fmt::format("<div><dt>{}</dt><dd>{} <small>{}</small></dd></div>\n", escape_xml(name),
                     escape_xml(value), escape_xml(note));
}

std::string lane_tiles(const EvaluationResult& result) {
  if (result.baselines) return {};
  return tile("In the wrong lane", percent(wrong_lane_rate(result)), "of cycles with an ego lane") +
         tile("False lanes", factor(false_lanes_per_cycle(result)),
              fmt::format("a cycle; {} false boundaries", factor(false_boundaries_per_cycle(result)))) +
         tile("Resets", grouped(result.resets), "lanes lost and born anew") +
         tile("NEES", factor(mean_normalised_square(result.consistency)), "over all distances; 1 is honest");
}

std::string run_tiles(const RunFigures& run) {
  std::string tiles;
  if (run.duration_s) tiles += tile("Drive", fmt::format("{:.1f} s", *run.duration_s));
  if (run.inputs) {
    tiles += tile(
        "Inputs used", grouped(run.inputs->used),
        fmt::format("{} rejected, {} dropped", grouped(run.inputs->rejected), grouped(run.inputs->dropped)));
  }
  if (run.largest_graph) {
    tiles +=
        tile("Edges, largest graph", grouped(run.largest_graph->edges),
             fmt::format("{} poses, {} features", run.largest_graph->poses, run.largest_graph->features));
  }
  if (!run.cycle_ms.empty()) {
    tiles += tile("Median cycle", fmt::format("{:.1f} ms", percentile(run.cycle_ms, 0.5)),
                  fmt::format("p99 {:.1f}, max {:.1f} ms", percentile(run.cycle_ms, 0.99),
                              percentile(run.cycle_ms, 1)));
  }
  return tiles;
}

}  // namespace

std::string title_of(const Report& report) { return report.title.empty() ? "Lanefuse report" : report.title; }

std::string report_header(const Report& report) {
  const DriveInfo& drive = report.evaluation.drive;
  std::string html = "<h1>" + escape_xml(title_of(report)) + "</h1>\n<p class=\"drive\">Drive: " +
                     escape_xml(drive.name.empty() ? "unnamed" : drive.name);
  html += "; truth: " + escape_xml(report.evaluation.truth.empty() ? "none" : report.evaluation.truth);
  if (!report.evaluation.map.empty()) html += fmt::format(" {}", escape_xml(report.evaluation.map));
  if (const auto& survey = report.evaluation.surveyed) {
    html +=
        fmt::format(" (exact, with errors of {:.2f} m ego, {:.2f} m adjacent, {:.2f}&#176;; seed {})",
                    survey->ego, survey->adjacent, survey->heading * 180 / std::numbers::pi, survey->seed);
  }
  const std::string& estimator = report.evaluation.estimator;
  if (!estimator.empty()) html += "; estimator: " + escape_xml(estimator);
  if (!drive.preset_hash.empty()) html += "; sensor preset " + escape_xml(drive.preset_hash);
  return html + "</p>\n" + witness_line(drive.witness) + "<p class=\"verdict\">" +
         escape_xml(verdict(report.evaluation)) + "</p>\n";
}

std::string report_figures(const Report& report) {
  const EvaluationResult& result = report.evaluation;
  return "<dl class=\"tiles\">\n" +
         tile("Cycles", grouped(result.cycles),
              fmt::format("{} OK, {} with truth", grouped(result.cycles_ok),
                          grouped(result.cycles_with_truth))) +
         lane_tiles(result) + run_tiles(report.run) + "</dl>\n";
}

}  // namespace lanefuse
