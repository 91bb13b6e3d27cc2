// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/paper_words.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "drawing/html.hpp"
#include "evaluation/table_one.hpp"

namespace lanefuse {
namespace {

constexpr std::uint64_t kEnough = 200;  // deviations that a condition must have to be named

const char* lane_of(const PaperComparison& one) { return one.ego ? "ego lane" : "adjacent lanes"; }

/// "ego lane at 100 m (0.81 m, 1.47 times the paper's)"
std::string named(const PaperComparison& one) {
  return fmt::format("{} at {:.0f} m ({} m, {} times the paper's)", lane_of(one), one.distance_m,
                     metres(one.ours.rmse_m), factor(one.ratio));
}

std::vector<PaperComparison> those(const std::vector<PaperComparison>& all, AgainstPaper verdict) {
  std::vector<PaperComparison> result;
  std::copy_if(all.begin(), all.end(), std::back_inserter(result),
               [verdict](const PaperComparison& one) { return one.verdict == verdict; });
  return result;
}

std::string list_of(const std::vector<PaperComparison>& all) {
  std::string text;
  for (const bool ego : {true, false}) {
    bool first = true;
    for (const PaperComparison& one : all) {
      if (one.ego != ego) continue;
      if (first) {
        text += (text.empty() ? "" : "; ") + named(one);
      } else {
        text += fmt::format(", {:.0f} m ({} m, {:.2f})", one.distance_m, metres(one.ours.rmse_m), one.ratio);
      }
      first = false;
    }
  }
  return text;
}

const PaperComparison& extreme(const std::vector<PaperComparison>& all, bool largest) {
  return *std::max_element(all.begin(), all.end(), [largest](const auto& a, const auto& b) {
    return largest ? a.ratio < b.ratio : a.ratio > b.ratio;
  });
}

/// The condition under which that lane's error at that distance was largest.
const ConditionStatistics* worst_of(const std::vector<ConditionStatistics>& conditions,
                                    const PaperComparison& one, double& rmse) {
  const ConditionStatistics* worst = nullptr;
  rmse = 0;
  for (const ConditionStatistics& condition : conditions) {
    for (const auto& at : one.ego ? condition.lanes.ego : condition.lanes.adjacent) {
      if (at.distance_m != one.distance_m || at.n < kEnough || at.rmse_m <= rmse) continue;
      rmse = at.rmse_m;
      worst = &condition;
    }
  }
  return worst;
}

std::string range_of(const ConditionStatistics& condition) {
  return std::isfinite(condition.to) ? fmt::format("{:g} to {:g}", condition.from, condition.to)
                                     : fmt::format("{:g} and more", condition.from);
}

/// What the figures say of one RMSE that is too large.
std::string reasons(const PaperComparison& one, const EvaluationResult& result) {
  const DeviationStatistics& at = one.ours;
  std::string text = fmt::format("The largest excess, {}: ", named(one));
  text += std::abs(at.mean_m) > at.sigma_m ? fmt::format("a bias, mean {} m. ", metres(at.mean_m))
                                           : fmt::format("scatter, sigma {} m around a mean of {} m. ",
                                                         metres(at.sigma_m), metres(at.mean_m));
  if (at.rmse_m > 0.7 * at.p95_m) {
    text += fmt::format(
        "A few gross errors make it: 95 % of the deviations stay below {} m; the estimate was in "
        "the wrong lane in {} of the cycles. ",
        metres(at.p95_m), percent(wrong_lane_rate(result)));
  }
  double rmse = 0;
  if (const auto* worst = worst_of(result.by_gap_ahead, one, rmse)) {
    text += fmt::format("Largest with the next vehicle {} m ahead: {} m. ", range_of(*worst), metres(rmse));
  }
  if (const auto* worst = worst_of(result.by_vehicles_ahead, one, rmse)) {
    text += fmt::format("Largest with {} vehicles ahead: {} m. ", range_of(*worst), metres(rmse));
  }
  return text;
}

/// How much of an RMSE the survey's own error is.
std::string without_survey(const PaperComparison& one, const SurveyedTruthConfig& survey) {
  const double own = std::hypot(one.ego ? survey.ego : survey.adjacent, survey.heading * one.distance_m);
  const auto rest = [own](double rmse) { return std::sqrt(std::max(0.0, rmse * rmse - own * own)); };
  return fmt::format(
      "At {:.0f} m the truth's own error is {} m of it; without that {} m are left for the {}, where "
      "the paper's figure leaves {} m. ",
      one.distance_m, metres(own), metres(rest(one.ours.rmse_m)), lane_of(one), metres(rest(one.paper.rmse)));
}

/// What a better figure has to be asked.
std::string doubts(const PaperComparison& one, const EvaluationResult& result) {
  std::string text;
  if (result.surveyed) {
    text += without_survey(one, *result.surveyed);
    text += "A method that is better than the paper's or sensors that are kinder both would do this. ";
  } else if (!result.map.empty()) {
    text += "The truth is another map here, whose own errors are not known. ";
  } else {
    text += "Most of this is the truth, which has no error here and had one in the paper. ";
  }
  if (!result.serial_camera) return text;
  for (const auto& at : result.serial_camera->extrapolated) {
    if (at.distance_m != one.distance_m || at.n == 0) continue;
    text += fmt::format("The serial camera alone, extrapolated, is off by {} m at {:.0f} m in the ego lane. ",
                        metres(at.rmse_m), at.distance_m);
  }
  return text;
}

}  // namespace

std::vector<std::string> words_on_table_one(const EvaluationResult& result) {
  const std::vector<PaperComparison> all = compare_with_table_one(result.lanes);
  const std::vector<PaperComparison> worse = those(all, AgainstPaper::worse);
  const std::vector<PaperComparison> better = those(all, AgainstPaper::better);
  if (those(all, AgainstPaper::not_judged).size() == all.size())
    return {"Nothing could be compared with Table I."};
  std::vector<std::string> paragraphs;
  if (worse.empty() && better.empty()) {
    paragraphs.push_back(
        "Every RMSE is within 35 % of Table I at 0 to 80 m, and within a factor of 2 beyond.");
  }
  if (!worse.empty()) {
    paragraphs.push_back("Worse than Table I by more than 35 % (by more than a factor of 2 beyond 80 m): " +
                         list_of(worse) + ". " + reasons(extreme(worse, true), result));
  }
  if (!better.empty()) {
    paragraphs.push_back("Better than Table I by more than 35 % (by more than a factor of 2 beyond 80 m): " +
                         list_of(better) + ". " + doubts(extreme(better, false), result));
  }
  return paragraphs;
}

}  // namespace lanefuse
