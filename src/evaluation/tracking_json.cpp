// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/tracking_json.hpp"

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kToDegrees = 180 / std::numbers::pi;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

void add_counts(Json& json, const TrackingCounts& counts) {
  json["mota"] = number(counts.mota());
  json["idf1"] = number(counts.idf1());
  json["recall"] = number(counts.recall());
  json["precision"] = number(counts.precision());
  json["id_switches_per_vehicle_hour"] = number(counts.id_switches_per_vehicle_hour());
  json["id_switches"] = counts.id_switches;
  json["vehicle_hours"] = counts.vehicle_hours;
  json["vehicles"] = counts.vehicles;
  json["hits"] = counts.hits;
  json["false_tracks"] = counts.false_tracks;
}

void add_errors(Json& json, const TrackingFigures& figures) {
  for (std::size_t bin = 0; bin < TrackingFigures::kBins; ++bin) {
    const TrackErrors& errors = figures.ahead[bin];
    json["range_from_m"].push_back(TrackingFigures::kBinLength * static_cast<double>(bin));
    json["lateral_rmse_m"].push_back(number(errors.lateral_rmse()));
    json["lateral_nees"].push_back(number(errors.lateral_nees()));
    json["heading_rmse_deg"].push_back(number(errors.heading_rmse() * kToDegrees));
    json["n"].push_back(errors.n);
  }
}

}  // namespace

Json to_json(const TrackingFigures& figures) {
  Json json{{"frames", figures.frames},
            {"hours", figures.hours},
            {"gospa_m", number(figures.gospa())},
            {"gospa_parts_m2",
             {{"localisation", number(figures.a_frame(figures.localisation_sum))},
              {"missed", number(figures.a_frame(figures.missed_sum))},
              {"false", number(figures.a_frame(figures.false_sum))}}}};
  add_counts(json, figures.all);
  json["tracks"] = figures.tracks;
  json["false_confirmed_per_hour"] = number(figures.an_hour(figures.false_confirmed));
  json["false_confirmed"] = figures.false_confirmed;
  json["witnesses"] = figures.witnesses;
  json["false_witnesses_per_hour"] = number(figures.an_hour(figures.false_witnesses));
  json["false_witnesses"] = figures.false_witnesses;
  json["time_to_confirm_s"] = {{"median", number(figures.confirm_s.quantile(0.5))},
                               {"p95", number(figures.confirm_s.quantile(0.95))},
                               {"n", figures.confirmed},
                               {"never", figures.never_confirmed}};
  add_errors(json, figures);
  json["near"]["range_m"] = figures.near_range;
  add_counts(json["near"], figures.near);
  return json;
}

}  // namespace lanefuse
