// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/coverage_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/text_grid.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

std::string number(const std::optional<FigureMean>& mean, int digits, double factor = 1) {
  return mean ? fmt::format("{:.{}f}", factor * mean->value, digits) : "-";
}

/// Where all or none are inside, the interval has one end only, and is left to the JSON.
std::string with_interval(const std::optional<FigureMean>& mean, int digits, double factor) {
  if (!mean || !mean->low || !mean->high || mean->value >= 1 || mean->value <= 0)
    return number(mean, digits, factor);
  return fmt::format("{} ±{:.{}f}", number(mean, digits, factor), factor * (*mean->high - *mean->low) / 2,
                     digits);
}

/// None at all still has an upper end of its confidence interval.
std::string rate_cell(const std::optional<FigureMean>& rate) {
  if (!rate || rate->value > 0 || !rate->high) return with_interval(rate, 3, 100);
  return fmt::format("0, < {:.1f}", 100 * *rate->high);
}

std::string verdict_cell(const CoverageAt& at) {
  if (!at.verdict) return "-";
  return fmt::format("{}{}", to_string(*at.verdict), at.certain ? "" : " ?");
}

TextRow row_of(const char* lane, const CoverageAt& at) {
  return {fmt::format("{} {:.0f} m", lane, at.distance_m),
          with_interval(at.within[0], 1, 100),
          with_interval(at.within[1], 1, 100),
          with_interval(at.within[2], 1, 100),
          verdict_cell(at),
          number(at.stated_sigma, 3),
          number(at.rmse, 3),
          number(at.nees, 2),
          number(at.protection, 2),
          rate_cell(at.misleading_rate)};
}

std::string heading(const Coverage& coverage, bool markdown) {
  const HonestCount count = honest_count(coverage);
  return fmt::format("{}{}: {}, truth {}, {} drives of {} km; honest in {} of {} places\n\n",
                     markdown ? "### " : "", coverage.name, coverage.estimator, coverage.truth,
                     coverage.drives, coverage.km, count.honest, count.of);
}

std::string table(const Coverage& coverage, bool markdown) {
  std::vector<TextRow> rows{{"", "in 68 % [%]", "in 95 % [%]", "in 99 % [%]", "intervals are", "sigma [m]",
                             "RMSE [m]", "NEES", "bound [m]", "beyond [%]"}};
  for (std::size_t i = 0; i < coverage.ego.size(); i += 2) rows.push_back(row_of("ego", coverage.ego[i]));
  for (std::size_t i = 0; i < coverage.adjacent.size(); i += 2) {
    rows.push_back(row_of("adjacent", coverage.adjacent[i]));
  }
  return heading(coverage, markdown) + text_grid(rows, markdown);
}

std::string legend(const std::vector<Coverage>& all) {
  std::string text = fmt::format(
      "honest: within {:g}, {:g} and {:g} points of 68, 95 and 99 %, counted every 10 m; ?: the drives' "
      "scatter "
      "leaves doubt.\n±: half of the 95 % confidence interval over drives. sigma: mean of the stated ones; "
      "bound: mean protection level;\nbeyond: share of the deviations that exceeded theirs.\n",
      100 * kCoverageLevels[0].tolerance, 100 * kCoverageLevels[1].tolerance,
      100 * kCoverageLevels[2].tolerance);
  const bool few = std::any_of(all.begin(), all.end(),
                               [](const Coverage& coverage) { return coverage.drives < kEnoughDrives; });
  if (few)
    text +=
        fmt::format("Fewer than {} drives say little: some errors are one draw a drive.\n", kEnoughDrives);
  return text;
}

Json end(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json to_json(const std::optional<FigureMean>& mean) {
  if (!mean) return {};
  return {
      {"mean", mean->value}, {"low", end(mean->low)}, {"high", end(mean->high)}, {"drives", mean->drives}};
}

Json to_json(const std::vector<CoverageAt>& lane) {
  Json list = Json::array();
  for (const CoverageAt& at : lane) {
    list.push_back({{"distance_m", at.distance_m},
                    {"within_68", to_json(at.within[0])},
                    {"within_95", to_json(at.within[1])},
                    {"within_99", to_json(at.within[2])},
                    {"verdict", at.verdict ? Json(to_string(*at.verdict)) : Json()},
                    {"certain", at.certain},
                    {"stated_sigma_m", to_json(at.stated_sigma)},
                    {"rmse_m", to_json(at.rmse)},
                    {"nees", to_json(at.nees)},
                    {"protection_m", to_json(at.protection)},
                    {"misleading_rate", to_json(at.misleading_rate)},
                    {"n_protected", at.n_protected}});
  }
  return list;
}

}  // namespace

std::string to_text(const std::vector<Coverage>& all, bool markdown) {
  std::string text;
  for (const Coverage& coverage : all) text += fmt::format("{}\n", table(coverage, markdown));
  return text + legend(all);
}

Json to_json(const std::vector<Coverage>& all) {
  Json list = Json::array();
  for (const Coverage& coverage : all) {
    const HonestCount count = honest_count(coverage);
    list.push_back({{"name", coverage.name},
                    {"estimator", coverage.estimator},
                    {"truth", coverage.truth},
                    {"km", coverage.km},
                    {"noise", coverage.noise},
                    {"drives", coverage.drives},
                    {"honest", count.honest},
                    {"judged", count.of},
                    {"ego", to_json(coverage.ego)},
                    {"adjacent", to_json(coverage.adjacent)}});
  }
  return list;
}

}  // namespace lanefuse
