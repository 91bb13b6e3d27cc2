// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluation_text.hpp"

#include <fmt/format.h>

namespace lanefuse {
namespace {

std::string row(const DeviationStatistics& s) {
  if (s.n == 0) return fmt::format("{:>7} {:>6} {:>6} {:>6} {:>6}", "-", "-", "-", "-", "0 %");
  return fmt::format("{:7.2f} {:6.2f} {:6.2f} {:6.2f} {:4.0f} %", s.mean_m, s.sigma_m, s.rmse_m, s.p95_m,
                     100 * s.availability);
}

}  // namespace

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
