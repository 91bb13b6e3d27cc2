// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluation_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json statistics_json(const std::vector<DeviationStatistics>& all) {
  Json list = Json::array();
  for (const DeviationStatistics& s : all) {
    list.push_back({{"distance_m", s.distance_m},
                    {"mean_m", number(s.mean_m)},
                    {"sigma_m", number(s.sigma_m)},
                    {"rmse_m", number(s.rmse_m)},
                    {"p95_m", number(s.p95_m)},
                    {"availability", number(s.availability)},
                    {"n", s.n}});
  }
  return list;
}

Json consistency_json(const std::vector<ConsistencyStatistics>& all) {
  Json list = Json::array();
  for (const ConsistencyStatistics& s : all) {
    list.push_back({{"distance_m", s.distance_m}, {"nees", number(s.mean_normalised_square)}, {"n", s.n}});
  }
  return list;
}

Json ego_path_json(const EvaluationResult& result, const BaselineStatistics& baselines) {
  Json json;
  json["baselines"] = {{"straight", statistics_json(baselines.straight)},
                       {"arc", statistics_json(baselines.arc)},
                       {"straight_where_available", statistics_json(baselines.straight_where_available)},
                       {"arc_where_available", statistics_json(baselines.arc_where_available)}};
  Json& ahead = json["availability_with_vehicle_ahead"] = Json::array();
  for (const AvailabilityStatistics& s : result.availability_with_vehicle_ahead) {
    ahead.push_back(
        {{"distance_m", s.distance_m}, {"availability", number(s.availability)}, {"cycles", s.cycles}});
  }
  return json;
}

std::string row(const DeviationStatistics& s) {
  if (s.n == 0) return fmt::format("{:>7} {:>6} {:>6} {:>6} {:>6}", "-", "-", "-", "-", "0 %");
  return fmt::format("{:7.2f} {:6.2f} {:6.2f} {:6.2f} {:4.0f} %", s.mean_m, s.sigma_m, s.rmse_m, s.p95_m,
                     100 * s.availability);
}

}  // namespace

std::string to_json(const EvaluationResult& result) {
  Json json{
      {"truth", result.truth},
      {"drive", result.drive.name},
      {"witness", to_string(result.drive.witness)},
      {"preset_hash", result.drive.preset_hash},
      {"cycles", result.cycles},
      {"cycles_ok", result.cycles_ok},
      {"cycles_with_truth", result.cycles_with_truth},
      {"lanes",
       {{"ego", statistics_json(result.lanes.ego)}, {"adjacent", statistics_json(result.lanes.adjacent)}}}};
  if (result.baselines) {
    json.update(ego_path_json(result, *result.baselines));
  } else {
    json["wrong_lane_rate"] = number(wrong_lane_rate(result));
    json["false_boundaries_per_frame"] = number(false_boundaries_per_cycle(result));
    json["consistency"] = {{"ego", consistency_json(result.consistency.ego)},
                           {"adjacent", consistency_json(result.consistency.adjacent)}};
  }
  return json.dump();
}

std::string to_table(const EvaluationResult& result) {
  const bool path = result.baselines.has_value();
  std::string text = fmt::format("{}, truth: {}, witness: {}\n", result.drive.name, result.truth,
                                 to_string(result.drive.witness));
  const char* columns = "   mean  sigma   rmse    p95  avail";
  text += fmt::format("{:>8} | {:35} | {}\n", "", path ? "ego lane's centre [m]" : "ego lane [m]",
                      path ? "rmse [m]: straight  arc" : "adjacent lanes [m]");
  text += fmt::format("{:>8} |{:36} | {}\n", "distance", columns, path ? "" : columns);
  for (std::size_t i = 0; i < result.lanes.ego.size(); ++i) {
    const std::string other = path ? fmt::format("{:18.2f} {:4.2f}", result.baselines->straight[i].rmse_m,
                                                 result.baselines->arc[i].rmse_m)
                                   : row(result.lanes.adjacent[i]);
    text +=
        fmt::format("{:6.0f} m | {} | {}\n", result.lanes.ego[i].distance_m, row(result.lanes.ego[i]), other);
  }
  return text;
}

}  // namespace lanefuse
