// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "drawing/chart.hpp"
#include "drawing/drive_map.hpp"
#include "drawing/evaluation_charts.hpp"
#include "drawing/html.hpp"
#include "drawing/report_parts.hpp"

namespace lanefuse {
namespace {

constexpr std::array<std::size_t, 4> kShown{0, 4, 8, 12};  // indices of 0, 40, 80, 120 m

std::string range_of(const ConditionStatistics& condition, bool whole_numbers) {
  if (!std::isfinite(condition.to)) {
    return whole_numbers ? fmt::format("{:.0f} and more", condition.from)
                         : fmt::format("above {:.0f}, or none", condition.from);
  }
  if (!whole_numbers) return fmt::format("{:.0f}-{:.0f}", condition.from, condition.to);
  if (condition.to - condition.from == 1) return fmt::format("{:.0f}", condition.from);
  return fmt::format("{:.0f}-{:.0f}", condition.from, condition.to - 1);
}

std::string condition_table(const std::string& name, const std::vector<ConditionStatistics>& conditions,
                            bool whole_numbers) {
  HtmlTable table;
  const int shown = static_cast<int>(kShown.size());
  table.group_headings({{"", 2}, {"ego lane, RMSE [m] at", shown}, {"adjacent lanes, RMSE [m] at", shown}});
  std::vector<std::string> headings{name, "cycles"};
  for (int lane = 0; lane < 2; ++lane) {
    for (const std::size_t i : kShown) headings.push_back(fmt::format("{:.0f} m", distance_at(i)));
  }
  table.headings(headings);
  for (const ConditionStatistics& condition : conditions) {
    std::vector<std::string> row{range_of(condition, whole_numbers), grouped(condition.cycles)};
    for (const auto* lanes : {&condition.lanes.ego, &condition.lanes.adjacent}) {
      for (const std::size_t i : kShown) row.push_back(metres((*lanes)[i].rmse_m));
    }
    table.row(row);
  }
  return table.html();
}

}  // namespace

std::string camera_section(const EvaluationResult& result) {
  if (!result.serial_camera) return {};
  HtmlTable table;
  table.group_headings({{"", 1},
                        {"fused: ego lane [m]", 3},
                        {"serial camera, extrapolated [m]", 3},
                        {"serial camera, within its range [m]", 3}});
  std::vector<std::string> headings{"distance [m]"};
  for (int group = 0; group < 3; ++group) headings.insert(headings.end(), {"mean", "RMSE", "available"});
  table.headings(headings);
  const auto& [extrapolated, within_range] = *result.serial_camera;
  for (std::size_t i = 0; i < extrapolated.size(); i += 2) {
    std::vector<std::string> row{fmt::format("{:.0f}", extrapolated[i].distance_m)};
    for (const auto* at : {&result.lanes.ego[i], &extrapolated[i], &within_range[i]}) {
      row.insert(row.end(), {metres(at->mean_m), metres(at->rmse_m), percent(at->availability)});
    }
    table.row(row);
  }
  return "<h2>Beside the serial camera alone</h2>\n<p class=\"glossary\">The camera's own clothoids, moved "
         "from the "
         "edges of the paint to its centre and by the car's motion to the time of each cycle, judged by the "
         "same "
         "rules. <b>Extrapolated</b> follows them as far as lanes are judged, <b>within its range</b> only "
         "as far as "
         "the camera vouches for them.</p>\n" +
         table.html();
}

std::string traffic_section(const EvaluationResult& result) {
  if (result.by_vehicles_ahead.empty()) return {};
  return "<h2>Error and traffic</h2>\n<p class=\"glossary\">Vehicles ahead are those within 150 m on the ego "
         "lane and "
         "its neighbours. Others help where they bear witness of their lane, and hurt where they hide the "
         "paint.</p>\n<div class=\"charts\">\n" +
         inline_svg(draw_chart(
             condition_chart("Error by traffic", "vehicles ahead", result.by_vehicles_ahead, true))) +
         inline_svg(draw_chart(condition_chart("Error by the gap to the vehicle ahead",
                                               "gap [m]; the last point: further, or none",
                                               result.by_gap_ahead, false))) +
         "</div>\n" + condition_table("vehicles ahead", result.by_vehicles_ahead, true) +
         condition_table("gap ahead [m]", result.by_gap_ahead, false);
}

std::string map_section(const Report& report) {
  if (report.trace.empty()) return {};
  std::string html =
      "<h2>On the map</h2>\n" + inline_svg(draw_drive_map(report.trace)) + "<div class=\"charts\">\n";
  for (const Moment& moment : report.moments) {
    if (moment.world_from_vehicle) html += inline_svg(draw_on_map(moment.view, *moment.world_from_vehicle));
  }
  return html + "</div>\n";
}

}  // namespace lanefuse
