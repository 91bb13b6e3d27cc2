// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/comparison.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "benchmark/student_t.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

using Side = std::map<DriveKey, const ResultLine*>;

/// What of a drive's key must agree for two to be a pair, beside what was driven.
struct Named {
  bool variant = false;
  bool estimator = false;
};

/// Whether some side holds several values of a part of its keys, which then must be told apart by name.
bool holds_several(std::span<const ResultLine> a, std::span<const ResultLine> b,
                   std::string DriveKey::*part) {
  const auto several = [part](std::span<const ResultLine> lines) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const ResultLine& line) { return line.key.*part != lines.front().key.*part; });
  };
  return several(a) || several(b);
}

/// The lines by what was driven, and by what drove it as far as that is to be `named`.
Side by_drive(std::span<const ResultLine> lines, const Named& named) {
  Side side;
  for (const ResultLine& line : lines) {
    DriveKey key = line.key;
    if (!named.variant) key.variant.clear();
    if (!named.estimator) key.estimator.clear();
    const auto [known, is_new] = side.emplace(key, &line);
    if (!is_new) {
      throw configuration_error(line.place, fmt::format("is the same drive as {}", known->second->place));
    }
  }
  return side;
}

void demand_same_sensors_and_scenes(std::span<const ResultLine> a, std::span<const ResultLine> b) {
  std::map<std::string, const ResultLine*> first_of_scene;
  const ResultLine* first = nullptr;
  for (const auto& side : {a, b}) {
    for (const ResultLine& line : side) {
      if (!first) first = &line;
      const ResultLine& alike = *first_of_scene.try_emplace(line.key.scene, &line).first->second;
      const auto refuse = [&line](const ResultLine& other, const char* what) {
        throw configuration_error(line.place,
                                  fmt::format("was simulated with another {} than {}", what, other.place),
                                  "only drives that were simulated alike can be compared");
      };
      if (line.provenance.preset != first->provenance.preset) refuse(*first, "preset");
      if (line.provenance.scene != alike.provenance.scene) refuse(alike, "scenario");
    }
  }
}

/// The kinds of drives, whatever their seeds.
std::set<DriveKey> kinds_of(const Side& side) {
  std::set<DriveKey> kinds;
  for (const auto& [key, line] : side) {
    DriveKey kind = key;
    kind.seed = 0;
    kinds.insert(kind);
  }
  return kinds;
}

struct Values {
  std::vector<double> a;
  std::vector<double> b;
};

Values paired_values(const BenchmarkFigure& figure, const Side& a, const Side& b) {
  Values values;
  for (const auto& [key, line] : a) {
    const auto partner = b.find(key);
    if (partner == b.end()) continue;
    const auto in_a = value_of(figure, line->json);
    const auto in_b = value_of(figure, partner->second->json);
    if (!in_a || !in_b) continue;
    values.a.push_back(*in_a);
    values.b.push_back(*in_b);
  }
  return values;
}

std::vector<double> all_values(const BenchmarkFigure& figure, const Side& side) {
  std::vector<double> values;
  for (const auto& [key, line] : side) {
    if (const auto value = value_of(figure, line->json)) values.push_back(*value);
  }
  return values;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

FigureChange change_of(const BenchmarkFigure& figure, const Values& values, bool paired) {
  FigureChange change{
      &figure, mean(values.a),  mean(values.b), {}, std::min(values.a.size(), values.b.size()),
      {},      Verdict::unknown};
  if (!paired) {
    change.change = unpaired_difference(values.a, values.b);
    return change;
  }
  std::vector<double> differences;
  std::transform(values.b.begin(), values.b.end(), values.a.begin(), std::back_inserter(differences),
                 std::minus<>());
  change.change = paired_difference(differences);
  return change;
}

Verdict verdict_of(const FigureChange& change) {
  if (!change.chance) return Verdict::unknown;
  if (*change.chance >= kSignificance) return Verdict::noise;
  const bool is_lower = change.change.mean < 0;
  return is_lower == (change.figure->better == BenchmarkFigure::Better::lower) ? Verdict::better
                                                                               : Verdict::worse;
}

/// Corrects for the number of figures, and judges each.
void judge(std::vector<FigureChange>& changes) {
  std::vector<double> probabilities;
  for (const FigureChange& change : changes) {
    if (change.change.probability) probabilities.push_back(*change.change.probability);
  }
  const std::vector<double> corrected = holm(probabilities);
  auto next = corrected.begin();
  for (FigureChange& change : changes) {
    if (change.change.probability) change.chance = *next++;
    change.verdict = verdict_of(change);
  }
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::better:
      return "better";
    case Verdict::worse:
      return "worse";
    case Verdict::noise:
      return "noise";
    case Verdict::unknown:
      break;
  }
  return "unknown";
}

Comparison compare(std::span<const ResultLine> a, std::span<const ResultLine> b) {
  demand_same_sensors_and_scenes(a, b);
  const Named named{holds_several(a, b, &DriveKey::variant), holds_several(a, b, &DriveKey::estimator)};
  const Side in_a = by_drive(a, named);
  const Side in_b = by_drive(b, named);
  Comparison result;
  result.pairs = static_cast<std::size_t>(std::count_if(
      in_a.begin(), in_a.end(), [&in_b](const auto& entry) { return in_b.contains(entry.first); }));
  result.only_in_a = in_a.size() - result.pairs;
  result.only_in_b = in_b.size() - result.pairs;
  if (in_a.empty() || in_b.empty() || (result.pairs == 0 && kinds_of(in_a) != kinds_of(in_b))) {
    throw configuration_error("compare", "the two sides have no drive in common",
                              "compare the same scene, road, length and truth, best with the same seeds");
  }
  const bool paired = result.pairs > 0;
  for (const BenchmarkFigure& figure : figures()) {
    const Values values = paired ? paired_values(figure, in_a, in_b)
                                 : Values{all_values(figure, in_a), all_values(figure, in_b)};
    if (!values.a.empty() && !values.b.empty()) result.figures.push_back(change_of(figure, values, paired));
  }
  judge(result.figures);
  return result;
}

}  // namespace lanefuse
