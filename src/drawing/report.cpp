// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/report.hpp"

#include "drawing/chart.hpp"
#include "drawing/evaluation_charts.hpp"
#include "drawing/report_parts.hpp"

namespace lanefuse {
namespace {

std::string charts(const Report& report) {
  std::string html = "<div class=\"charts\">\n";
  if (report.evaluation.baselines) html += inline_svg(draw_chart(rmse_chart(report.evaluation)));
  html += inline_svg(draw_chart(bias_chart(report.evaluation)));
  html += inline_svg(draw_chart(availability_chart(report.evaluation)));
  if (!report.evaluation.consistency.ego.empty()) {
    html += inline_svg(draw_chart(consistency_chart(report.evaluation)));
    html += inline_svg(draw_chart(coverage_chart(report.evaluation)));
  }
  html += inline_svg(draw_cycle_times(report.run.cycle_ms));
  return html + "</div>\n";
}

std::string moments(const Report& report) {
  if (report.moments.empty()) return {};
  std::string html = "<h2>Moments from above</h2>\n";
  for (const Moment& moment : report.moments) {
    html += "<figure>\n" + inline_svg(draw_top_view(moment.view)) + "<figcaption>" +
            escape_xml(moment.caption) + "</figcaption>\n</figure>\n";
  }
  return html;
}

}  // namespace

std::string write_report(const Report& report) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         escape_xml(title_of(report)) + "</title>\n<style>" + report_css() +
         "</style>\n</head>\n<body>\n<main>\n" + report_header(report) + report_figures(report) +
         paper_section(report.evaluation) + "<h2>By distance</h2>\n" + charts(report) +
         deviation_table(report.evaluation) + uncertainty_table(report.evaluation) +
         report_glossary(report.evaluation) + camera_section(report.evaluation) +
         traffic_section(report.evaluation) + tracking_section(report.evaluation) + map_section(report) +
         moments(report) + "</main>\n</body>\n</html>\n";
}

}  // namespace lanefuse
