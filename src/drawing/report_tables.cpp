// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "drawing/html.hpp"
#include "drawing/report_parts.hpp"

namespace lanefuse {
namespace {

using Row = std::vector<std::string>;

void append(Row& row, const Row& more) { row.insert(row.end(), more.begin(), more.end()); }

Row lane_cells(const DeviationStatistics& at) {
  return {metres(at.mean_m), metres(at.sigma_m),       metres(at.rmse_m),
          metres(at.p95_m),  percent(at.availability), grouped(at.n)};
}

const Row kLaneHeadings{"mean", "sigma", "RMSE", "p95", "available", "n"};

const Row kUncertaintyHeadings{"sigma [m]", "in 68 %", "in 95 %", "in 99 %", "bound [m]", "beyond [%]"};

Row uncertainty_cells(const ConsistencyStatistics& at) {
  return {
      metres(at.stated_sigma_m), percent(at.within_68),
      percent(at.within_95),     percent(at.within_99),
      metres(at.protection_m),   at.n_protected == 0 ? "-" : fmt::format("{:.3f}", 100 * at.misleading_rate)};
}

std::string exact_table(const EvaluationResult& result) {
  HtmlTable table;
  table.group_headings({{"", 1}, {"ego lane [m]", 7}, {"adjacent lanes [m]", 7}});
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
  table.group_headings(
      {{"", 1}, {"ego lane's centre [m]", 7}, {"arc, RMSE [m]", 2}, {"straight, RMSE [m]", 2}});
  Row headings{"distance [m]"};
  append(headings, kLaneHeadings);
  append(headings, {"vehicle ahead", "all", "same", "all", "same"});
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

std::string deviation_table(const EvaluationResult& result) {
  if (result.lanes.ego.empty()) return "<p>No data.</p>\n";
  return result.baselines ? ego_path_table(result) : exact_table(result);
}

std::string uncertainty_table(const EvaluationResult& result) {
  const LaneConsistency& consistency = result.consistency;
  if (consistency.ego.empty()) return "";
  HtmlTable table;
  table.group_headings({{"", 1}, {"what the ego lane states", 6}, {"what adjacent lanes state", 6}});
  Row headings{"distance [m]"};
  for (int lane = 0; lane < 2; ++lane) append(headings, kUncertaintyHeadings);
  table.headings(headings);
  for (std::size_t i = 0; i < consistency.ego.size() && i < consistency.adjacent.size(); ++i) {
    Row row{fmt::format("{:.0f}", consistency.ego[i].distance_m)};
    append(row, uncertainty_cells(consistency.ego[i]));
    append(row, uncertainty_cells(consistency.adjacent[i]));
    table.row(row);
  }
  return table.html();
}

std::string report_glossary(const EvaluationResult& result) {
  std::string html =
      "<p class=\"glossary\"><b>Deviation</b> is estimate minus truth, positive to the left, measured across "
      "the true line "
      "at the point where the estimate is sampled. <b>p95</b> is the magnitude that 95 % of the deviations "
      "do not exceed. "
      "<b>Available</b> is the share of the cycles with truth at that distance in which the estimate reached "
      "it; <b>n</b> "
      "counts the deviations. ";
  html += result.baselines
              ? "Truth is the path that the car drove later, so that the driver's own wandering "
                "in the lane is in every "
                "figure. <b>Vehicle ahead</b> is the availability among the cycles in which a "
                "moving vehicle is tracked "
                "ahead. <b>Arc</b> and <b>straight</b> perceive no lane: the circle of the "
                "smoothed yaw rate, and the line "
                "ahead. <b>All</b> takes every cycle, <b>same</b> those in which the estimate "
                "reached that distance too."
              : "<b>Ego</b> are both boundaries of the lane that the car is in; <b>adjacent</b> "
                "are the outer boundaries "
                "of its neighbours, where those lanes exist. <b>NEES</b> is the mean of "
                "(deviation / stated sigma)&#178;: 1 "
                "is honest, above is overconfident. <b>In 68 %</b> is the share of the deviations inside "
                "the interval that should hold 68 % of them, were they normal with the stated sigma. "
                "<b>Bound</b> is the protection level, which the error is promised to stay inside, "
                "<b>beyond</b> the share that did not. A boundary is <b>false</b> when it is more "
                "than 1 m from every true "
                "one; a lane is false when its middle is in no true one, or a true boundary runs inside it.";
  return html + "</p>\n";
}

}  // namespace lanefuse
