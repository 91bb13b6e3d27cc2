// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/summary.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "benchmark/scene.hpp"
#include "benchmark/variant.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

std::string group_name(const DriveKey& key, GroupBy by) {
  switch (by) {
    case GroupBy::variant:
      return key.variant;
    case GroupBy::scene:
      return key.scene;
    case GroupBy::road:
      return key.road;
    case GroupBy::drive_kind:
      break;
  }
  return fmt::format("{}, {}, {}", key.scene, key.road, key.variant);
}

bool is_nominal(const ResultLine& line) {
  return line.key.scene == kNominalScene && line.key.noise == 1 &&
         line.key.variant == variants().front().name;
}

/// Refuses two lines with one `kind` that were made from different `what`.
class Unmixed {
 public:
  explicit Unmixed(const char* what) : what_(what) {}

  void check(const std::string& kind, const std::string& hash, const ResultLine& line) {
    const auto [known, is_new] = first_.try_emplace(kind, std::pair(hash, line.place));
    const auto& [first_hash, first_place] = known->second;
    if (is_new || first_hash == hash) return;
    throw input_error(
        line.place,
        fmt::format("{} comes from {} {}, and {} from {}", kind, what_, hash, first_place, first_hash),
        "keep them in files of their own, and compare those");
  }

 private:
  const char* what_;
  std::map<std::string, std::pair<std::string, std::string>> first_;
};

void demand_unmixed(std::span<const ResultLine> lines) {
  Unmixed presets("preset");
  Unmixed scenes("scenario");
  Unmixed configurations("configuration");
  Unmixed versions("version");
  for (const ResultLine& line : lines) {
    const std::string system = fmt::format("{} {}", line.key.estimator, line.key.variant);
    presets.check("all that is simulated", line.provenance.preset, line);
    scenes.check(line.key.scene, line.provenance.scene, line);
    configurations.check(system, line.provenance.configuration, line);
    versions.check(system, line.provenance.version, line);
  }
}

Summary summary_of(const std::string& name, const std::vector<const ResultLine*>& lines) {
  std::vector<const nlohmann::ordered_json*> jsons;
  for (const ResultLine* line : lines) jsons.push_back(&line->json);
  const DriveKey& key = lines.front()->key;
  Summary summary{name,
                  std::all_of(lines.begin(), lines.end(), [](const auto* line) { return is_nominal(*line); }),
                  key.estimator,
                  key.truth,
                  key.km,
                  key.noise,
                  lines.size(),
                  {}};
  for (const BenchmarkFigure& figure : figures()) summary.means.push_back(mean_of(figure, jsons));
  return summary;
}

}  // namespace

std::vector<DriveGroup> group_drives(std::span<const ResultLine> lines, GroupBy by) {
  demand_unmixed(lines);
  using GroupKey = std::tuple<std::string, std::string, std::string, double, double>;
  std::map<GroupKey, std::size_t> places;
  std::vector<DriveGroup> groups;
  for (const ResultLine& line : lines) {
    const std::string name = group_name(line.key, by) + noise_in_name(line.key.noise);
    const auto [place, is_new] = places.try_emplace(
        {name, line.key.estimator, line.key.truth, line.key.km, line.key.noise}, groups.size());
    if (is_new) groups.push_back({name, {}});
    groups[place->second].lines.push_back(&line);
  }
  return groups;
}

std::vector<Summary> summarise(std::span<const ResultLine> lines, GroupBy by) {
  const std::vector<DriveGroup> groups = group_drives(lines, by);
  std::vector<Summary> summaries;
  const EstimatorRatios ratios(lines);
  for (const auto& [name, members] : groups) {
    summaries.push_back(summary_of(name, members));
    summaries.back().ratios = ratios.of(members);
  }
  return summaries;
}

}  // namespace lanefuse
