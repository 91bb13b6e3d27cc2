// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/evaluation_charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lanefuse {
namespace {

// RMSE [m] at 0, 20 ... 120 m [IROS16, table I].
constexpr std::array kPaperEgo{0.10, 0.11, 0.18, 0.28, 0.42, 0.55, 0.64};
constexpr std::array kPaperAdjacent{0.21, 0.21, 0.27, 0.37, 0.50, 0.66, 0.99};

Axis distance_axis() { return {"distance ahead [m]", 0, distance_at(kDistanceCount - 1), 10}; }

using Points = std::vector<Eigen::Vector2d>;

Points rmse_of(const std::vector<DeviationStatistics>& statistics) {
  Points points;
  for (const DeviationStatistics& at : statistics) points.emplace_back(at.distance_m, at.rmse_m);
  return points;
}

template <typename Statistics>
Points percent_available(const std::vector<Statistics>& statistics) {
  Points points;
  for (const Statistics& at : statistics) points.emplace_back(at.distance_m, 100 * at.availability);
  return points;
}

Points paper(const std::array<double, 7>& rmse) {
  Points points;
  for (std::size_t i = 0; i < rmse.size(); ++i) points.emplace_back(20.0 * static_cast<double>(i), rmse[i]);
  return points;
}

double largest_value(const std::vector<Series>& series) {
  double largest = 0;
  for (const Series& one : series) {
    for (const auto& point : one.points) {
      if (std::isfinite(point.y())) largest = std::max(largest, std::abs(point.y()));
    }
  }
  return largest;
}

/// The mean with markers, and the lines one sigma above and below it.
void add_mean(std::vector<Series>& series, const std::string& label,
              const std::vector<DeviationStatistics>& lane, const std::string& colour) {
  Points mean, above, below;
  for (const DeviationStatistics& at : lane) {
    mean.emplace_back(at.distance_m, at.mean_m);
    above.emplace_back(at.distance_m, at.mean_m + at.sigma_m);
    below.emplace_back(at.distance_m, at.mean_m - at.sigma_m);
  }
  const Marker marker = series.empty() ? Marker::circle : Marker::square;
  series.push_back({label, mean, colour, marker});
  series.push_back({"", above, colour, std::nullopt, true});
  series.push_back({"one sigma", below, colour, std::nullopt, true});
}

bool judged(const std::vector<DeviationStatistics>& statistics) {
  return std::any_of(statistics.begin(), statistics.end(), [](const auto& at) { return at.n > 0; });
}

}  // namespace

Chart rmse_chart(const EvaluationResult& result) {
  Chart chart{"RMSE by distance", distance_axis(), {}, {}};
  const auto add = [&chart](Series series) { chart.series.push_back(std::move(series)); };
  if (result.baselines) {
    add({"ego lane's centre", rmse_of(result.lanes.ego), "series-0", Marker::circle});
    add({"arc of the yaw rate", rmse_of(result.baselines->arc), "series-2", Marker::triangle, true});
    add({"straight ahead", rmse_of(result.baselines->straight), "series-3", Marker::diamond, true});
  } else if (judged(result.lanes.ego) || judged(result.lanes.adjacent)) {
    add({"ego lane", rmse_of(result.lanes.ego), "series-0", Marker::circle});
    add({"adjacent lanes", rmse_of(result.lanes.adjacent), "series-1", Marker::square});
    add({"ego, Table I", paper(kPaperEgo), "series-0", std::nullopt, true});
    add({"adjacent, Table I", paper(kPaperAdjacent), "series-1", std::nullopt, true});
  }
  chart.y = axis_from_zero("RMSE [m]", largest_value(chart.series), 6);
  return chart;
}

Chart bias_chart(const EvaluationResult& result) {
  Chart chart{"Mean deviation, with one sigma", distance_axis(), {}, {}};
  add_mean(chart.series, result.baselines ? "ego lane's centre" : "ego lane", result.lanes.ego, "series-0");
  if (judged(result.lanes.adjacent)) {
    add_mean(chart.series, "adjacent lanes", result.lanes.adjacent, "series-1");
  }
  Axis half = axis_from_zero("to the left [m]", largest_value(chart.series), 3);
  half.from = -half.to;
  chart.y = half;
  return chart;
}

Chart availability_chart(const EvaluationResult& result) {
  Chart chart{"Availability by distance", distance_axis(), {"share of cycles [%]", 0, 100, 20}, {}};
  const bool against_path = result.baselines.has_value();
  chart.series.push_back({against_path ? "ego lane's centre, all cycles" : "ego lane",
                          percent_available(result.lanes.ego), "series-0", Marker::circle});
  if (!result.lanes.adjacent.empty()) {
    chart.series.push_back(
        {"adjacent lanes", percent_available(result.lanes.adjacent), "series-1", Marker::square});
  }
  if (!result.availability_with_vehicle_ahead.empty()) {
    chart.series.push_back({"cycles with a vehicle tracked ahead",
                            percent_available(result.availability_with_vehicle_ahead), "series-4",
                            Marker::diamond});
  }
  return chart;
}

}  // namespace lanefuse
