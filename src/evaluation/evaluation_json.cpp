// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/evaluation_json.hpp"

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "evaluation/tracking_json.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

template <typename Entry, typename ToJson>
Json list_of(const std::vector<Entry>& entries, ToJson to_json_of) {
  Json list = Json::array();
  for (const Entry& entry : entries) list.push_back(to_json_of(entry));
  return list;
}

Json deviations(const std::vector<DeviationStatistics>& all) {
  return list_of(all, [](const DeviationStatistics& s) {
    return Json{{"distance_m", s.distance_m},
                {"mean_m", number(s.mean_m)},
                {"sigma_m", number(s.sigma_m)},
                {"rmse_m", number(s.rmse_m)},
                {"p95_m", number(s.p95_m)},
                {"availability", number(s.availability)},
                {"n", s.n}};
  });
}

Json lanes(const LaneStatistics& statistics) {
  return {{"ego", deviations(statistics.ego)}, {"adjacent", deviations(statistics.adjacent)}};
}

Json consistency(const std::vector<ConsistencyStatistics>& all) {
  return list_of(all, [](const ConsistencyStatistics& s) {
    return Json{{"distance_m", s.distance_m},
                {"nees", number(s.mean_normalised_square)},
                {"n", s.n},
                {"within_68", number(s.within_68)},
                {"within_95", number(s.within_95)},
                {"within_99", number(s.within_99)},
                {"stated_sigma_m", number(s.stated_sigma_m)},
                {"protection_m", number(s.protection_m)},
                {"misleading_rate", number(s.misleading_rate)},
                {"n_protected", s.n_protected}};
  });
}

/// Without mean, sigma and p95: a condition is there to be compared with the next, not to be studied.
Json condition_deviations(const std::vector<DeviationStatistics>& all) {
  return list_of(all, [](const DeviationStatistics& s) {
    return Json{{"distance_m", s.distance_m},
                {"rmse_m", number(s.rmse_m)},
                {"availability", number(s.availability)},
                {"n", s.n}};
  });
}

Json conditions(const std::vector<ConditionStatistics>& all) {
  return list_of(all, [](const ConditionStatistics& s) {
    return Json{{"from", s.from},
                {"to", number(s.to)},
                {"cycles", s.cycles},
                {"ego", condition_deviations(s.lanes.ego)},
                {"adjacent", condition_deviations(s.lanes.adjacent)}};
  });
}

void add_path_figures(Json& json, const EvaluationResult& result, const BaselineStatistics& baselines) {
  json["baselines"] = {{"straight", deviations(baselines.straight)},
                       {"arc", deviations(baselines.arc)},
                       {"straight_where_available", deviations(baselines.straight_where_available)},
                       {"arc_where_available", deviations(baselines.arc_where_available)}};
  json["availability_with_vehicle_ahead"] =
      list_of(result.availability_with_vehicle_ahead, [](const AvailabilityStatistics& s) {
        return Json{
            {"distance_m", s.distance_m}, {"availability", number(s.availability)}, {"cycles", s.cycles}};
      });
}

void add_road_figures(Json& json, const EvaluationResult& result) {
  json["wrong_lane_rate"] = number(wrong_lane_rate(result));
  json["false_boundaries_per_frame"] = number(false_boundaries_per_cycle(result));
  json["false_lanes_per_frame"] = number(false_lanes_per_cycle(result));
  json["resets"] = result.resets;
  json["nees"] = number(mean_normalised_square(result.consistency));
  json["consistency"] = {{"ego", consistency(result.consistency.ego)},
                         {"adjacent", consistency(result.consistency.adjacent)}};
  json["by_vehicles_ahead"] = conditions(result.by_vehicles_ahead);
  json["by_gap_ahead"] = conditions(result.by_gap_ahead);
  if (const auto& camera = result.serial_camera) {
    json["serial_camera"] = {{"extrapolated", deviations(camera->extrapolated)},
                             {"within_range", deviations(camera->within_range)}};
  }
  if (result.tracking) json["tracking"] = to_json(*result.tracking);
  if (const auto& survey = result.surveyed) {
    json["surveyed"] = {{"ego_m", survey->ego},
                        {"adjacent_m", survey->adjacent},
                        {"heading_deg", survey->heading / kDegree},
                        {"seed", survey->seed}};
  }
}

}  // namespace

Json to_json(const EvaluationResult& result) {
  Json json{{"truth", result.truth},
            {"drive", result.drive.name},
            {"witness", to_string(result.drive.witness)},
            {"preset_hash", result.drive.preset_hash},
            {"cycles", result.cycles},
            {"cycles_ok", result.cycles_ok},
            {"cycles_with_truth", result.cycles_with_truth},
            {"lanes", lanes(result.lanes)}};
  if (!result.estimator.empty()) json["estimator"] = result.estimator;
  if (!result.map.empty()) json["map"] = result.map;
  if (result.baselines) {
    add_path_figures(json, result, *result.baselines);
  } else {
    add_road_figures(json, result);
  }
  return json;
}

}  // namespace lanefuse
