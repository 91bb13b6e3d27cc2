// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/coverage.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "evaluation/deviation.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;
using Lines = std::vector<const Json*>;

/// A mean over lines of what stands at `value` of each, weighted by what stands at `weight`.
std::optional<FigureMean> pooled(const Lines& lines, const std::string& value, const std::string& weight,
                                 BenchmarkFigure::Mean mean = BenchmarkFigure::Mean::plain) {
  return mean_of({"", "", value, weight, BenchmarkFigure::Better::lower, mean}, lines);
}

/// A pooled share. Where every drive says none, or all, their scatter says nothing: then a drive in which it
/// is the other way may be as likely as 1 - 0.05^(1/drives) and still not have been met.
std::optional<FigureMean> pooled_share(const Lines& lines, const std::string& value,
                                       const std::string& weight) {
  std::optional<FigureMean> share = pooled(lines, value, weight);
  if (!share || !share->low || !share->high || *share->low != *share->high) return share;
  const double unseen = 1 - std::pow(0.05, 1 / static_cast<double>(share->drives));
  share->low = std::max(0.0, share->value - unseen);
  share->high = std::min(1.0, share->value + unseen);
  return share;
}

std::uint64_t sum_at(const Lines& lines, const std::string& pointer) {
  const Json::json_pointer where(pointer);
  std::uint64_t sum = 0;
  for (const Json* line : lines) {
    if (line->contains(where)) sum += line->at(where).get<std::uint64_t>();
  }
  return sum;
}

/// By how much a share lies outside what the level may hold: above zero too much, below too little.
double excess(double share, const CoverageLevel& level) {
  const double off = share - level.share;
  return std::abs(off) <= level.tolerance ? 0 : off;
}

CoverageVerdict verdict_of(const std::array<double, 3>& excesses) {
  const bool more = std::any_of(excesses.begin(), excesses.end(), [](double e) { return e > 0; });
  const bool less = std::any_of(excesses.begin(), excesses.end(), [](double e) { return e < 0; });
  if (more && less) return CoverageVerdict::wrong_tails;
  if (less) return CoverageVerdict::too_narrow;
  return more ? CoverageVerdict::too_wide : CoverageVerdict::honest;
}

/// Whether both ends of the confidence interval say the same as the mean does.
bool is_certain(const FigureMean& share, const CoverageLevel& level) {
  if (!share.low || !share.high) return false;
  const auto side = [&level](double value) {
    const double off = excess(value, level);
    return off > 0 ? 1 : off < 0 ? -1 : 0;
  };
  return side(*share.low) == side(share.value) && side(*share.high) == side(share.value);
}

/// An honest verdict needs every level to be certain, another one at least one level that is certainly off.
void judge(CoverageAt& at) {
  std::array<double, 3> excesses{};
  bool all_certain = true;
  bool certainly_off = false;
  for (std::size_t i = 0; i < kCoverageLevels.size(); ++i) {
    if (!at.within[i]) return;
    excesses[i] = excess(at.within[i]->value, kCoverageLevels[i]);
    const bool certain = is_certain(*at.within[i], kCoverageLevels[i]);
    all_certain = all_certain && certain;
    certainly_off = certainly_off || (certain && excesses[i] != 0);
  }
  at.verdict = verdict_of(excesses);
  at.certain = at.verdict == CoverageVerdict::honest ? all_certain : certainly_off;
}

CoverageAt coverage_at(const Lines& lines, const char* lane, std::size_t distance) {
  const std::string stated = fmt::format("/consistency/{}/{}", lane, distance);
  const std::string judged = fmt::format("/lanes/{}/{}", lane, distance);
  const std::string n = stated + "/n";
  const std::string vouched = stated + "/n_protected";
  CoverageAt at;
  at.distance_m = distance_at(distance);
  at.within = {pooled_share(lines, stated + "/within_68", n), pooled_share(lines, stated + "/within_95", n),
               pooled_share(lines, stated + "/within_99", n)};
  at.stated_sigma = pooled(lines, stated + "/stated_sigma_m", n);
  at.rmse = pooled(lines, judged + "/rmse_m", judged + "/n", BenchmarkFigure::Mean::root_square);
  at.nees = pooled(lines, stated + "/nees", n);
  at.protection = pooled(lines, stated + "/protection_m", vouched);
  at.misleading_rate = pooled_share(lines, stated + "/misleading_rate", vouched);
  at.n_protected = sum_at(lines, vouched);
  judge(at);
  return at;
}

Coverage coverage_of(const DriveGroup& group) {
  Lines lines;
  for (const ResultLine* line : group.lines) lines.push_back(&line->json);
  const DriveKey& key = group.lines.front()->key;
  Coverage coverage{group.name, key.estimator, key.truth, key.km, key.noise, lines.size(), {}, {}};
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    coverage.ego.push_back(coverage_at(lines, "ego", i));
    coverage.adjacent.push_back(coverage_at(lines, "adjacent", i));
  }
  return coverage;
}

}  // namespace

const char* to_string(CoverageVerdict verdict) {
  switch (verdict) {
    case CoverageVerdict::honest:
      return "honest";
    case CoverageVerdict::too_narrow:
      return "too narrow";
    case CoverageVerdict::too_wide:
      return "too wide";
    case CoverageVerdict::wrong_tails:
      break;
  }
  return "wrong tails";
}

HonestCount honest_count(const Coverage& coverage) {
  HonestCount count;
  for (const auto* lane : {&coverage.ego, &coverage.adjacent}) {
    for (const CoverageAt& at : *lane) {
      if (!at.verdict) continue;
      ++count.of;
      if (*at.verdict == CoverageVerdict::honest) ++count.honest;
    }
  }
  return count;
}

std::vector<Coverage> coverage_of(std::span<const ResultLine> lines, GroupBy by) {
  std::vector<Coverage> all;
  for (const DriveGroup& group : group_drives(lines, by)) all.push_back(coverage_of(group));
  return all;
}

}  // namespace lanefuse
