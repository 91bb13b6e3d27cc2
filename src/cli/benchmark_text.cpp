// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/benchmark_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/text_grid.hpp"
#include "evaluation/table_one.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;
using Row = TextRow;

/// What the paper's Table I says of an RMSE among figures().
double paper_rmse(std::size_t figure) {
  const PaperRow& row = kTableOne[figure % kShownDistances];
  return figure < kShownDistances ? row.ego.rmse : row.adjacent.rmse;
}

std::string cell(const std::optional<FigureMean>& mean, int digits, double factor = 1) {
  if (!mean) return "-";
  if (!mean->low || !mean->high) return fmt::format("{:.{}f}", factor * mean->value, digits);
  return fmt::format("{:.{}f} ±{:.{}f}", factor * mean->value, digits,
                     factor * (*mean->high - *mean->low) / 2, digits);
}

/// Of rows that differ in their estimator alone, each says which it is.
std::string row_name(const std::vector<Summary>& summaries, const Summary& summary) {
  const bool one = std::all_of(summaries.begin(), summaries.end(),
                               [&](const Summary& other) { return other.estimator == summary.estimator; });
  return one ? summary.name : fmt::format("{}, {}", summary.name, summary.estimator);
}

Row rmse_row(const std::string& name, const Summary& summary, bool adjacent) {
  Row row{adjacent ? "" : name, adjacent ? "adjacent" : "ego"};
  for (std::size_t i = 0; i < kShownDistances; ++i)
    row.push_back(cell(summary.means[rmse_figure(adjacent, i)], 3));
  row.push_back(cell(summary.means[adjacent ? kAdjacentReaches : kEgoReaches], 1, 100));
  return row;
}

Row ratio_row(const EstimatorRatio& ratio, bool adjacent) {
  Row row{"", fmt::format("{} x {}", adjacent ? "adjacent" : "ego", ratio.to)};
  for (std::size_t i = 0; i < kShownDistances; ++i)
    row.push_back(cell(ratio.rmse[rmse_figure(adjacent, i)], 2));
  row.emplace_back("-");
  return row;
}

Row paper_row(bool adjacent) {
  Row row{adjacent ? "" : "the paper, Table I", adjacent ? "adjacent" : "ego"};
  for (std::size_t i = 0; i < kShownDistances; ++i)
    row.push_back(fmt::format("{:.2f}", paper_rmse(rmse_figure(adjacent, i))));
  row.emplace_back("-");
  return row;
}

std::string rmse_table(const std::vector<Summary>& summaries, bool markdown) {
  std::vector<Row> rows{{"drives", "lane", "0", "20", "40", "60", "80", "100", "120 m", "reaches 60 m [%]"}};
  bool nominal = false;
  for (const Summary& summary : summaries) {
    for (const bool adjacent : {false, true})
      rows.push_back(rmse_row(row_name(summaries, summary), summary, adjacent));
    for (const EstimatorRatio& ratio : summary.ratios) {
      for (const bool adjacent : {false, true}) rows.push_back(ratio_row(ratio, adjacent));
    }
    nominal = nominal || summary.nominal;
  }
  if (nominal) {
    for (const bool adjacent : {false, true}) rows.push_back(paper_row(adjacent));
  }
  return text_grid(rows, markdown);
}

std::string other_table(const std::vector<Summary>& summaries, bool markdown) {
  std::vector<Row> rows{{"drives", "how many", "km each", "estimator", "truth", "false lanes a frame",
                         "wrong-lane rate", "cycle p50 [ms]", "cycle p99 [ms]"}};
  for (const Summary& s : summaries) {
    rows.push_back({s.name, fmt::format("{}", s.drives), fmt::format("{}", s.km), s.estimator, s.truth,
                    cell(s.means[kFalseLanes], 4), cell(s.means[kWrongLane], 4),
                    cell(s.means[kCycleMedian], 2), cell(s.means[kCycleSlow], 2)});
  }
  return text_grid(rows, markdown);
}

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

void put(const char* key, const std::optional<FigureMean>& mean, Json& entry) {
  entry[key] = mean ? Json(mean->value) : Json();
  entry["low"] = number(mean ? mean->low : std::nullopt);
  entry["high"] = number(mean ? mean->high : std::nullopt);
  entry["drives"] = mean ? mean->drives : 0;
}

Json ratios_json(const std::vector<EstimatorRatio>& ratios) {
  Json list = Json::array();
  for (const EstimatorRatio& ratio : ratios) {
    Json entries = Json::array();
    for (std::size_t i = 0; i < ratio.rmse.size(); ++i) {
      put("ratio", ratio.rmse[i], entries.emplace_back(Json{{"figure", figures()[i].name}}));
    }
    list.push_back({{"to", ratio.to}, {"drives", ratio.drives}, {"figures", std::move(entries)}});
  }
  return list;
}

}  // namespace

std::string to_text(const std::vector<Summary>& summaries, bool markdown) {
  const bool ratios = std::any_of(summaries.begin(), summaries.end(),
                                  [](const Summary& summary) { return !summary.ratios.empty(); });
  return fmt::format(
      "RMSE [m] by distance ahead, ± half of the 95 % confidence interval over drives{}\n\n{}\n{}",
      ratios ? "; x: times the RMSE of that estimator on the same drives" : "",
      rmse_table(summaries, markdown), other_table(summaries, markdown));
}

Json to_json(const std::vector<Summary>& summaries) {
  Json list = Json::array();
  for (const Summary& summary : summaries) {
    Json row{{"name", summary.name}, {"estimator", summary.estimator}, {"truth", summary.truth},
             {"km", summary.km},     {"noise", summary.noise},         {"drives", summary.drives}};
    Json& means = row["figures"] = Json::array();
    for (std::size_t i = 0; i < summary.means.size(); ++i) {
      Json entry{{"figure", figures()[i].name}, {"unit", figures()[i].unit}};
      put("mean", summary.means[i], entry);
      if (summary.nominal && i < 2 * kShownDistances) entry["paper"] = paper_rmse(i);
      means.push_back(std::move(entry));
    }
    if (!summary.ratios.empty()) row["ratios"] = ratios_json(summary.ratios);
    list.push_back(std::move(row));
  }
  return list;
}

std::string to_text(const Comparison& comparison) {
  std::string text =
      comparison.pairs > 0
          ? fmt::format("{} drives in both, compared pair by pair; {} only in A, {} only in B\n",
                        comparison.pairs, comparison.only_in_a, comparison.only_in_b)
          : fmt::format("no drive in both: the {} of A and the {} of B are compared as a whole\n",
                        comparison.only_in_a, comparison.only_in_b);
  std::vector<Row> rows{{"figure", "A", "B", "B - A", "95 %", "chance", "B is"}};
  for (const FigureChange& f : comparison.figures) {
    const auto& half = f.change.half_width;
    rows.push_back(
        {f.figure->unit.empty() ? f.figure->name : fmt::format("{} [{}]", f.figure->name, f.figure->unit),
         fmt::format("{:.4f}", f.in_a), fmt::format("{:.4f}", f.in_b), fmt::format("{:+.4f}", f.change.mean),
         half ? fmt::format("±{:.4f}", *half) : "-", f.chance ? fmt::format("{:.3f}", *f.chance) : "-",
         f.verdict == Verdict::better || f.verdict == Verdict::worse
             ? fmt::format("significantly {}", to_string(f.verdict))
             : to_string(f.verdict)});
  }
  return fmt::format(
      "{}\n{}\nchance: probability of so large a difference where there is none, corrected for {} "
      "figures (Holm); below {} counts\n",
      text, text_grid(rows, false), comparison.figures.size(), kSignificance);
}

Json to_json(const Comparison& comparison) {
  Json json{
      {"pairs", comparison.pairs}, {"only_in_a", comparison.only_in_a}, {"only_in_b", comparison.only_in_b}};
  Json& list = json["figures"] = Json::array();
  for (const FigureChange& f : comparison.figures) {
    list.push_back({{"figure", f.figure->name},
                    {"unit", f.figure->unit},
                    {"a", f.in_a},
                    {"b", f.in_b},
                    {"difference", f.change.mean},
                    {"half_width", number(f.change.half_width)},
                    {"probability", number(f.change.probability)},
                    {"corrected_probability", number(f.chance)},
                    {"drives", f.drives},
                    {"verdict", to_string(f.verdict)}});
  }
  return json;
}

}  // namespace lanefuse
