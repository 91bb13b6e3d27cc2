// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluation_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cli/tracking_text.hpp"
#include "evaluation/table_one.hpp"

namespace lanefuse {
namespace {

std::string cells(const DeviationStatistics& s) {
  if (s.n == 0) return fmt::format("{:>6} {:>6} {:>6} {:>6} {:>6}", "-", "-", "-", "-", "0 %");
  return fmt::format("{:6.2f} {:6.2f} {:6.2f} {:6.2f} {:4.0f} %", s.mean_m, s.sigma_m, s.rmse_m, s.p95_m,
                     100 * s.availability);
}

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

std::string beside_paper(const PaperComparison& one) {
  return fmt::format("{} | {:5.2f} {:>6}", cells(one.ours), one.paper.rmse, number(one.ratio, 2));
}

std::string heading(const EvaluationResult& result) {
  std::string truth = result.truth;
  if (!result.map.empty()) truth += fmt::format(" {}", result.map);
  if (result.surveyed) truth += fmt::format(" (seed {})", result.surveyed->seed);
  const std::string estimator =
      result.estimator.empty() ? "" : fmt::format(", estimator: {}", result.estimator);
  return fmt::format("{}, truth: {}{}, witness: {}\n", result.drive.name, truth, estimator,
                     to_string(result.drive.witness));
}

constexpr const char* kColumns = "  mean  sigma   RMSE    p95  avail";

/// The layout of Table I, with its RMSE and the ratio beside each group of ours.
std::string road_table(const EvaluationResult& result) {
  std::string text = fmt::format("{:8} | {:34} | {:12} | {:34} | Table I\n", "", "ego lane [m]", "Table I",
                                 "adjacent lanes [m]");
  text += fmt::format("{:>8} | {} |  RMSE  ratio | {} |  RMSE  ratio\n", "distance", kColumns, kColumns);
  const std::vector<PaperComparison> figures = compare_with_table_one(result.lanes);
  for (std::size_t i = 0; i + 1 < figures.size(); i += 2) {
    text += fmt::format("{:6.0f} m | {} | {}\n", figures[i].distance_m, beside_paper(figures[i]),
                        beside_paper(figures[i + 1]));
  }
  return text;
}

std::string rates(const EvaluationResult& result) {
  return fmt::format(
      "wrong lane {} %, false lanes {} a frame, false boundaries {} a frame, resets {}, NEES {}\n",
      number(100 * wrong_lane_rate(result), 2), number(false_lanes_per_cycle(result), 3),
      number(false_boundaries_per_cycle(result), 3), result.resets,
      number(mean_normalised_square(result.consistency), 2));
}

std::string shares(const ConsistencyStatistics& s) {
  const auto percent = [](double share) { return number(100 * share, 1); };
  return fmt::format("{:>6} {:>5} {:>5} {:>5} {:>5} {:>6} {:>7}", number(s.stated_sigma_m, 2),
                     number(s.mean_normalised_square, 2), percent(s.within_68), percent(s.within_95),
                     percent(s.within_99), number(s.protection_m, 2), number(100 * s.misleading_rate, 3));
}

/// Whether the stated uncertainty is honest, beside the RMSE that it speaks of.
std::string uncertainty_table(const LaneConsistency& consistency) {
  constexpr const char* kShares = " sigma  NEES  68 %  95 %  99 %  bound  beyond";
  std::string text =
      fmt::format("\n{:8} | {:45} | {}\n", "", "stated: ego lane [m], shares [%]", "adjacent lanes");
  text += fmt::format("{:>8} | {} | {}\n", "distance", kShares, kShares);
  for (std::size_t i = 0; i < consistency.ego.size(); i += 2) {
    text += fmt::format("{:6.0f} m | {} | {}\n", consistency.ego[i].distance_m, shares(consistency.ego[i]),
                        shares(consistency.adjacent[i]));
  }
  return text;
}

std::string camera_table(const SerialCameraStatistics& camera) {
  std::string text =
      fmt::format("\n{:8} | {:34} | within its range [m]\n", "", "serial camera, extrapolated [m]");
  text += fmt::format("{:>8} | {} | {}\n", "distance", kColumns, kColumns);
  for (std::size_t i = 0; i < camera.extrapolated.size(); i += 2) {
    text += fmt::format("{:6.0f} m | {} | {}\n", camera.extrapolated[i].distance_m,
                        cells(camera.extrapolated[i]), cells(camera.within_range[i]));
  }
  return text;
}

std::string path_table(const EvaluationResult& result) {
  const auto& ego = result.lanes.ego;
  std::string text = fmt::format("{:8} | {:34} | RMSE [m]: straight  arc\n", "", "ego lane's centre [m]");
  text += fmt::format("{:>8} | {} |\n", "distance", kColumns);
  for (std::size_t i = 0; i < ego.size(); ++i) {
    text += fmt::format("{:6.0f} m | {} | {:18.2f} {:4.2f}\n", ego[i].distance_m, cells(ego[i]),
                        result.baselines->straight[i].rmse_m, result.baselines->arc[i].rmse_m);
  }
  return text;
}

}  // namespace

std::string to_table(const EvaluationResult& result) {
  if (result.baselines) return heading(result) + path_table(result);
  std::string text = heading(result) + road_table(result) + rates(result);
  text += uncertainty_table(result.consistency);
  if (result.serial_camera) text += camera_table(*result.serial_camera);
  if (result.tracking) text += fmt::format("\n{}", to_text({{"vehicles tracked", *result.tracking}}));
  return text;
}

}  // namespace lanefuse
