// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/report_parts.hpp"

#include <fmt/format.h>

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
         tile("False boundaries", factor(false_boundaries_per_cycle(result)), "a cycle");
}

std::string run_tiles(const RunFigures& run) {
  std::string tiles;
  if (run.duration_s) tiles += tile("Drive", fmt::format("{:.1f} s", *run.duration_s));
  if (run.inputs) {
    tiles += tile("Inputs used", fmt::format("{}", run.inputs->used),
                  fmt::format("{} rejected, {} dropped", run.inputs->rejected, run.inputs->dropped));
  }
  if (run.largest_graph) {
    tiles +=
        tile("Largest graph", fmt::format("{} edges", run.largest_graph->edges),
             fmt::format("{} poses, {} features", run.largest_graph->poses, run.largest_graph->features));
  }
  if (!run.cycle_ms.empty()) {
    tiles += tile("Cycle time", fmt::format("{:.1f} ms", percentile(run.cycle_ms, 0.5)),
                  fmt::format("p99 {:.1f}, max {:.1f} ms", percentile(run.cycle_ms, 0.99),
                              percentile(run.cycle_ms, 1)));
  }
  return tiles;
}

using Row = std::vector<std::string>;

void append(Row& row, const Row& more) { row.insert(row.end(), more.begin(), more.end()); }

Row lane_cells(const DeviationStatistics& at) {
  return {metres(at.mean_m), metres(at.sigma_m),       metres(at.rmse_m),
          metres(at.p95_m),  percent(at.availability), fmt::format("{}", at.n)};
}

const Row kLaneHeadings{"mean [m]", "sigma [m]", "RMSE [m]", "p95 [m]", "available", "n"};

std::string exact_table(const EvaluationResult& result) {
  HtmlTable table;
  table.group_headings({{"", 1}, {"ego lane", 7}, {"adjacent lanes", 7}});
  Row headings{"distance [m]"};
  for (int lane = 0; lane < 2; ++lane) {
    append(headings, kLaneHeadings);
    headings.emplace_back("NEES");
  }
  table.headings(headings);
  for (std::size_t i = 0; i < result.lanes.ego.size() && i < result.lanes.adjacent.size(); ++i) {
    Row row{fmt::format("{:.0f}", result.lanes.ego[i].distance_m)};
    append(row, lane_cells(result.lanes.ego[i]));
    row.push_back(i < result.consistency.ego.size() ? factor(result.consistency.ego[i].mean_normalised_square)
                                                    : "-");
    append(row, lane_cells(result.lanes.adjacent[i]));
    row.push_back(i < result.consistency.adjacent.size()
                      ? factor(result.consistency.adjacent[i].mean_normalised_square)
                      : "-");
    table.row(row);
  }
  return table.html();
}

std::string ego_path_table(const EvaluationResult& result) {
  HtmlTable table;
  table.group_headings({{"", 1}, {"ego lane's centre", 7}, {"arc: RMSE [m]", 2}, {"straight: RMSE [m]", 2}});
  Row headings{"distance [m]"};
  append(headings, kLaneHeadings);
  append(headings, {"with vehicle ahead", "all cycles", "same cycles", "all cycles", "same cycles"});
  table.headings(headings);
  const BaselineStatistics& baselines = *result.baselines;
  for (std::size_t i = 0; i < result.lanes.ego.size() && i < baselines.arc.size(); ++i) {
    Row row{fmt::format("{:.0f}", result.lanes.ego[i].distance_m)};
    append(row, lane_cells(result.lanes.ego[i]));
    const auto& ahead = result.availability_with_vehicle_ahead;
    row.push_back(i < ahead.size() ? percent(ahead[i].availability) : "-");
    for (const auto* baseline : {&baselines.arc, &baselines.arc_where_available, &baselines.straight,
                                 &baselines.straight_where_available}) {
      row.push_back(i < baseline->size() ? metres((*baseline)[i].rmse_m) : "-");
    }
    table.row(row);
  }
  return table.html();
}

}  // namespace

std::string report_header(const Report& report) {
  const DriveInfo& drive = report.evaluation.drive;
  std::string html = "<h1>" + escape_xml(report.title) + "</h1>\n<p class=\"drive\">Drive: " +
                     escape_xml(drive.name.empty() ? "unnamed" : drive.name);
  html += "; truth: " + escape_xml(report.evaluation.truth.empty() ? "none" : report.evaluation.truth);
  if (!drive.preset_hash.empty()) html += "; sensor preset " + escape_xml(drive.preset_hash);
  return html + "</p>\n" + witness_line(drive.witness) + "<p class=\"verdict\">" +
         escape_xml(verdict(report.evaluation)) + "</p>\n";
}

std::string report_figures(const Report& report) {
  const EvaluationResult& result = report.evaluation;
  return "<dl class=\"tiles\">\n" +
         tile("Cycles", fmt::format("{}", result.cycles),
              fmt::format("{} OK, {} with truth", result.cycles_ok, result.cycles_with_truth)) +
         lane_tiles(result) + run_tiles(report.run) + "</dl>\n";
}

std::string deviation_table(const EvaluationResult& result) {
  if (result.lanes.ego.empty()) return "<p>No data.</p>\n";
  return result.baselines ? ego_path_table(result) : exact_table(result);
}

std::string report_glossary(const EvaluationResult& result) {
  std::string html =
      R"(<p class="glossary"><b>Deviation</b> is estimate minus truth, positive to the left, measured )"
      R"(across the true line at the point where the estimate is sampled. <b>p95</b> is the magnitude )"
      R"(that 95 % of the deviations do not exceed. <b>Available</b> is the share of the cycles with truth )"
      R"(at that distance in which the estimate reached it; <b>n</b> counts the deviations. )";
  if (result.baselines) {
    html +=
        R"(Truth is the path that the car drove later, so that the driver's own wandering in the lane is in every )"
        R"(figure. <b>Arc</b> and <b>straight</b> perceive no lane: the circle of the smoothed yaw rate, and the )"
        R"(line ahead. <b>Same cycles</b> are those in which the estimate reached that distance too.)";
  } else {
    html +=
        R"(<b>Ego</b> are both boundaries of the lane that the car is in; <b>adjacent</b> are the outer boundaries of )"
        R"(its neighbours, where those lanes exist. <b>NEES</b> is the mean of (deviation / stated sigma)&#178;: 1 is )"
        R"(honest, above is overconfident. A boundary is <b>false</b> when it is more than 1 m from every true one.)";
  }
  return html + "</p>\n";
}

}  // namespace lanefuse
