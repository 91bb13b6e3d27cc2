// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/results_file.hpp"
#include "support/files.hpp"

namespace lanefuse::testing {

/// Lines of results without a drive behind them.
inline nlohmann::ordered_json distances(double rmse, std::uint64_t n) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (int i = 0; i < 13; ++i) list.push_back({{"rmse_m", rmse * (1 + i)}, {"availability", 1.0}, {"n", n}});
  return list;
}

/// The ego lane's RMSE at 0 m is `rmse`, all else follows from it; nothing is timed.
inline ResultLine result_line(const DriveKey& key, double rmse,
                              const Provenance& provenance = {"1", "p", "s", "c"}) {
  nlohmann::ordered_json json = head_json(key, provenance);
  json["lanes"] = {{"ego", distances(rmse, 100)}, {"adjacent", distances(2 * rmse, 100)}};
  json["wrong_lane_rate"] = 0.0;
  json["false_lanes_per_frame"] = nullptr;
  return parse_line(json.dump(), fmt::format("seed {}", key.seed));
}

inline DriveKey seed(std::uint64_t number) {
  DriveKey key;
  key.seed = number;
  return key;
}

/// One drive a value, seeds counted from 1.
inline std::vector<ResultLine> drives(const std::vector<double>& rmse) {
  std::vector<ResultLine> lines;
  for (std::size_t i = 0; i < rmse.size(); ++i) lines.push_back(result_line(seed(i + 1), rmse[i]));
  return lines;
}

}  // namespace lanefuse::testing
