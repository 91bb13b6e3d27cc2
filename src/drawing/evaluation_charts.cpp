// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/evaluation_charts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evaluation/table_one.hpp"

namespace lanefuse {
namespace {

constexpr const char* kEgoColour = "truth";  // red and blue, as in the paper's plot
constexpr const char* kAdjacentColour = "series-0";
constexpr const char* kCameraColour = "series-3";
constexpr std::uint64_t kEnoughCycles = 50;

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

Points paper(PaperFigures PaperRow::*lanes) {
  Points points;
  for (const PaperRow& row : kTableOne) points.emplace_back(row.distance, (row.*lanes).rmse);
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
    add({"ego lane", rmse_of(result.lanes.ego), kEgoColour, Marker::circle});
    add({"adjacent lanes", rmse_of(result.lanes.adjacent), kAdjacentColour, Marker::square});
    add({"ego, Table I", paper(&PaperRow::ego), kEgoColour, std::nullopt, true});
    add({"adjacent, Table I", paper(&PaperRow::adjacent), kAdjacentColour, std::nullopt, true});
    if (const auto& camera = result.serial_camera) {
      add({"serial camera alone", rmse_of(camera->extrapolated), kCameraColour, Marker::triangle, true});
    }
  }
  chart.y = axis_from_zero("RMSE [m]", largest_value(chart.series), 6);
  return chart;
}

Chart bias_chart(const EvaluationResult& result) {
  Chart chart{"Mean deviation, with one sigma", distance_axis(), {}, {}};
  add_mean(chart.series, result.baselines ? "ego lane's centre" : "ego lane", result.lanes.ego,
           result.baselines ? "series-0" : kEgoColour);
  if (judged(result.lanes.adjacent)) {
    add_mean(chart.series, "adjacent lanes", result.lanes.adjacent, kAdjacentColour);
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
                          percent_available(result.lanes.ego), against_path ? "series-0" : kEgoColour,
                          Marker::circle});
  if (!result.lanes.adjacent.empty()) {
    chart.series.push_back(
        {"adjacent lanes", percent_available(result.lanes.adjacent), kAdjacentColour, Marker::square});
  }
  if (!result.availability_with_vehicle_ahead.empty()) {
    chart.series.push_back({"cycles with a vehicle tracked ahead",
                            percent_available(result.availability_with_vehicle_ahead), "series-4",
                            Marker::diamond});
  }
  return chart;
}

Chart consistency_chart(const EvaluationResult& result) {
  Chart chart{"Consistency (NEES): 1 is honest, above is overconfident", distance_axis(), {}, {}};
  const auto nees_of = [](const std::vector<ConsistencyStatistics>& all) {
    Points points;
    for (const ConsistencyStatistics& at : all) points.emplace_back(at.distance_m, at.mean_normalised_square);
    return points;
  };
  if (!result.consistency.ego.empty()) {
    chart.series = {{"ego lane", nees_of(result.consistency.ego), kEgoColour, Marker::circle},
                    {"adjacent lanes", nees_of(result.consistency.adjacent), kAdjacentColour, Marker::square},
                    {"honest", {{0, 1}, {distance_at(kDistanceCount - 1), 1}}, "muted", std::nullopt, true}};
  }
  chart.y = axis_from_zero("mean (deviation / sigma)\u00b2", largest_value(chart.series), 6);
  return chart;
}

Chart coverage_chart(const EvaluationResult& result) {
  Chart chart{"Deviations inside the stated 95 % interval", distance_axis(), {"share [%]", 0, 100, 20}, {}};
  const auto inside = [](const std::vector<ConsistencyStatistics>& all) {
    Points points;
    for (const ConsistencyStatistics& at : all) points.emplace_back(at.distance_m, 100 * at.within_95);
    return points;
  };
  if (result.consistency.ego.empty()) return chart;
  chart.series = {{"ego lane", inside(result.consistency.ego), kEgoColour, Marker::circle},
                  {"adjacent lanes", inside(result.consistency.adjacent), kAdjacentColour, Marker::square},
                  {"95 %", {{0, 95}, {distance_at(kDistanceCount - 1), 95}}, "muted", std::nullopt, true}};
  return chart;
}

Chart condition_chart(const std::string& title, const std::string& axis,
                      const std::vector<ConditionStatistics>& conditions, bool whole_numbers) {
  Chart chart{title, {axis, 0, 1, 1}, {}, {}};
  const auto middle = [&](std::size_t i) {
    const double step = i > 0 ? conditions[i].from - conditions[i - 1].from : 1;
    const double width = std::isfinite(conditions[i].to) ? conditions[i].to - conditions[i].from : step;
    return conditions[i].from + (width - (whole_numbers ? 1 : 0)) / 2;
  };
  const auto over_ranges = [&](std::vector<DeviationStatistics> LaneStatistics::*lanes,
                               std::size_t distance) {
    Points points;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      if (conditions[i].cycles < kEnoughCycles) continue;
      points.emplace_back(middle(i), (conditions[i].lanes.*lanes)[distance].rmse_m);
    }
    return points;
  };
  if (conditions.empty()) return chart;
  chart.x = axis_from_zero(axis, middle(conditions.size() - 1), 8);
  for (const auto& [distance, dashed] : {std::pair{std::size_t{6}, false}, {std::size_t{12}, true}}) {
    const std::string at = dashed ? "120 m" : "60 m";
    chart.series.push_back(
        {"ego, " + at, over_ranges(&LaneStatistics::ego, distance), kEgoColour, Marker::circle, dashed});
    chart.series.push_back({"adjacent, " + at, over_ranges(&LaneStatistics::adjacent, distance),
                            kAdjacentColour, Marker::square, dashed});
  }
  chart.y = axis_from_zero("RMSE [m]", largest_value(chart.series), 6);
  return chart;
}

Chart tracking_chart(const TrackingFigures& figures) {
  constexpr double kReach = TrackingFigures::kBinLength * TrackingFigures::kBins;
  Chart chart{"Tracked vehicles: lateral RMSE by range",
              {"distance ahead [m]", 0, kReach, TrackingFigures::kBinLength},
              {},
              {}};
  Points rmse;
  Points stated;
  for (std::size_t bin = 0; bin < TrackingFigures::kBins; ++bin) {
    const TrackErrors& errors = figures.ahead[bin];
    const double middle = (static_cast<double>(bin) + 0.5) * TrackingFigures::kBinLength;
    rmse.emplace_back(middle, errors.lateral_rmse());
    stated.emplace_back(middle, errors.stated_lateral());
  }
  chart.series.push_back({"measured", rmse, kAdjacentColour, Marker::circle});
  chart.series.push_back({"stated by the tracks", stated, "muted", std::nullopt, true});
  chart.y = axis_from_zero("RMSE [m]", largest_value(chart.series), 6);
  return chart;
}

}  // namespace lanefuse
