// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include <fmt/format.h>

#include "drawing/chart.hpp"
#include "drawing/evaluation_charts.hpp"
#include "drawing/html.hpp"
#include "drawing/report_parts.hpp"

namespace lanefuse {
namespace {

constexpr double kToDegrees = 180 / std::numbers::pi;

void add_counts(HtmlTable& table, const std::string& name, const TrackingCounts& counts) {
  table.row({name, percent(counts.mota()), percent(counts.idf1()), percent(counts.recall()),
             percent(counts.precision()), factor(counts.id_switches_per_vehicle_hour()),
             grouped(counts.vehicles)});
}

std::string counts_table(const TrackingFigures& figures) {
  HtmlTable table;
  table.headings({"true vehicles", "MOTA", "IDF1", "recall", "precision", "id switches a vehicle-hour", "n"});
  add_counts(table, "all in range", figures.all);
  add_counts(table, fmt::format("within {:.0f} m", figures.near_range), figures.near);
  return table.html();
}

std::string errors_table(const TrackingFigures& figures) {
  HtmlTable table;
  table.headings({"distance ahead [m]", "lateral RMSE [m]", "stated [m]", "NEES", "heading RMSE [°]", "n"});
  for (std::size_t bin = 0; bin < TrackingFigures::kBins; ++bin) {
    const TrackErrors& errors = figures.ahead[bin];
    const double from = TrackingFigures::kBinLength * static_cast<double>(bin);
    table.row({fmt::format("{:.0f}-{:.0f}", from, from + TrackingFigures::kBinLength),
               metres(errors.lateral_rmse()), metres(errors.stated_lateral()), factor(errors.lateral_nees()),
               factor(kToDegrees * errors.heading_rmse()), grouped(errors.n)});
  }
  return table.html();
}

/// What no table shows, in a sentence each.
std::string words(const TrackingFigures& figures) {
  return fmt::format(
      "<p class=\"glossary\">GOSPA (cut off at 4 m): {} m a frame. Tracks on no vehicle for most of their "
      "life: {} of {}, {} an hour. Witnesses where no vehicle was: {} of {}, {} an hour. From the first "
      "sight "
      "of a vehicle to its first track: {} s in the median, {} s at the 95th percentile; {} vehicles never "
      "got "
      "one. <b>Vehicles</b> count within 150 m ahead and 50 m beside and behind, unless others have hidden "
      "them for more than 2 s.</p>\n",
      metres(figures.gospa()), grouped(figures.false_confirmed), grouped(figures.tracks),
      factor(figures.an_hour(figures.false_confirmed)), grouped(figures.false_witnesses),
      grouped(figures.witnesses), factor(figures.an_hour(figures.false_witnesses)),
      metres(figures.confirm_s.quantile(0.5)), metres(figures.confirm_s.quantile(0.95)),
      grouped(figures.never_confirmed));
}

}  // namespace

std::string tracking_section(const EvaluationResult& result) {
  if (!result.tracking) return {};
  const TrackingFigures& figures = *result.tracking;
  return "<h2>Vehicles tracked</h2>\n" + words(figures) + counts_table(figures) + "<div class=\"charts\">\n" +
         inline_svg(draw_chart(tracking_chart(figures))) + "</div>\n" + errors_table(figures);
}

}  // namespace lanefuse
