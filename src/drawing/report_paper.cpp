// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "drawing/chart.hpp"
#include "drawing/evaluation_charts.hpp"
#include "drawing/html.hpp"
#include "drawing/paper_words.hpp"
#include "drawing/report_parts.hpp"
#include "evaluation/table_one.hpp"

namespace lanefuse {
namespace {

using Row = std::vector<std::string>;

void append(Row& row, const PaperComparison& one) {
  for (const double value : {one.ours.mean_m, one.ours.sigma_m, one.ours.rmse_m})
    row.push_back(metres(value));
  for (const double value : {one.paper.mean, one.paper.sigma, one.paper.rmse}) row.push_back(metres(value));
  row.push_back(factor(one.ratio));
}

std::string table(const std::vector<PaperComparison>& figures) {
  HtmlTable table;
  table.group_headings({{"", 1},
                        {"ego lane [m]", 3},
                        {"Table I", 3},
                        {"", 1},
                        {"adjacent lanes [m]", 3},
                        {"Table I", 3},
                        {"", 1}});
  Row headings{"distance [m]"};
  for (int lane = 0; lane < 2; ++lane) {
    for (const char* name : {"mean", "sigma", "RMSE", "mean", "sigma", "RMSE", "ratio"}) {
      headings.emplace_back(name);
    }
  }
  table.headings(headings);
  for (std::size_t i = 0; i + 1 < figures.size(); i += 2) {
    Row row{fmt::format("{:.0f}", figures[i].distance_m)};
    append(row, figures[i]);
    append(row, figures[i + 1]);
    table.row(row);
  }
  return table.html();
}

std::string caption(const EvaluationResult& result) {
  std::string text =
      "The paper measured against a map of its own, surveyed with the same kind of car, on 24 km of its own "
      "roads. ";
  if (result.surveyed) {
    text += "Here the truth has that map's errors laid on it, so the two may be compared.";
  } else if (!result.map.empty()) {
    text += "Here the truth is a map, too, whose own errors are in ours.";
  } else {
    text +=
        "Here the truth has no error of its own, so ours should be the smaller: for a fair comparison judge "
        "by "
        "surveyed truth.";
  }
  text += " The ratio is of the RMSE, ours by the paper's.";
  return "<p class=\"glossary\">" + text + "</p>\n";
}

}  // namespace

std::string paper_section(const EvaluationResult& result) {
  if (result.baselines || result.lanes.ego.empty()) return {};
  std::string html = "<h2>Beside the paper's Table I</h2>\n" + caption(result) + "<div class=\"charts\">\n" +
                     inline_svg(draw_chart(rmse_chart(result))) + "<div>\n";
  for (const std::string& paragraph : words_on_table_one(result)) {
    html += "<p>" + escape_xml(paragraph) + "</p>\n";
  }
  return html + "</div>\n</div>\n" + table(compare_with_table_one(result.lanes));
}

}  // namespace lanefuse
