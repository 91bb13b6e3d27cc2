// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/result_line.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

DriveKey key_of(const Json& json) {
  return {json.at("scene"),   json.at("road"),      json.at("seed"),  json.at("km"),
          json.at("variant"), json.at("estimator"), json.at("truth"), json.value("noise", 1.0)};
}

/// A noise of one may be said or left out.
Json without_times(Json json) {
  if (json.value("noise", 1.0) == 1) json.erase("noise");
  for (const char* key : kTimeKeys) json.erase(key);
  return json;
}

}  // namespace

Json head_json(const DriveKey& key, const Provenance& provenance) {
  Json head{{"scene", key.scene},     {"road", key.road},           {"seed", key.seed},  {"km", key.km},
            {"variant", key.variant}, {"estimator", key.estimator}, {"truth", key.truth}};
  if (key.noise != 1) head["noise"] = key.noise;
  head.update({{"version", provenance.version},
               {"preset", provenance.preset},
               {"scene_hash", provenance.scene},
               {"configuration_hash", provenance.configuration}});
  return head;
}

ResultLine parse_line(const std::string& text, const std::string& place) {
  try {
    Json json = Json::parse(text);
    if (!json.at("lanes").is_object() || !json.at("seed").is_number_unsigned()) {
      throw input_error(place, "is no line of benchmark results");
    }
    const DriveKey key = key_of(json);
    if (!std::isfinite(key.km) || !(key.noise > 0))
      throw input_error(place, "is no line of benchmark results");
    return {key,
            {json.at("version"), json.at("preset"), json.at("scene_hash"), json.at("configuration_hash")},
            std::move(json),
            text,
            place};
  } catch (const nlohmann::json::exception& e) {
    throw input_error(place, fmt::format("is no line of benchmark results: {}", e.what()));
  }
}

bool same_figures(const ResultLine& a, const ResultLine& b) {
  return without_times(a.json) == without_times(b.json);
}

std::string differing(const Provenance& here, const Provenance& there) {
  if (here.preset != there.preset)
    return fmt::format("preset ({} here, {} there)", here.preset, there.preset);
  if (here.scene != there.scene) return fmt::format("scene ({} here, {} there)", here.scene, there.scene);
  if (here.configuration != there.configuration) {
    return fmt::format("configuration ({} here, {} there)", here.configuration, there.configuration);
  }
  return fmt::format("version ({} here, {} there)", here.version, there.version);
}

void demand_same_provenance(const ResultLine& a, const ResultLine& b) {
  if (a.provenance == b.provenance) return;
  throw input_error(b.place,
                    fmt::format("{} is in {}, too, from another {}", to_string(b.key), a.place,
                                differing(b.provenance, a.provenance)),
                    "keep them in files of their own, and compare those");
}

}  // namespace lanefuse
