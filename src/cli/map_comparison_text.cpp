// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/map_comparison_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "drawing/chart.hpp"

namespace lanefuse {
namespace {

constexpr double kChartStep = 50;  ///< [m] of road that one point of the picture stands for

nlohmann::ordered_json deviation_json(const LineDeviation& deviation) {
  return {{"points", deviation.count},
          {"mean", deviation.mean},
          {"rmse", deviation.rmse},
          {"p95", deviation.p95},
          {"max", deviation.max}};
}

std::string row(const std::string& name, const LineDeviation& deviation, const std::string& covered) {
  const auto metres = [&](double value) {
    if (deviation.count == 0) return std::string("-");
    return fmt::format("{:.4f}", std::abs(value) < 5e-5 ? 0 : value);  // no minus before a zero
  };
  return fmt::format("{:<10} {:>8} {:>8} {:>8} {:>8} {:>8}  {}\n", name, deviation.count,
                     metres(deviation.mean), metres(deviation.rmse), metres(deviation.p95),
                     metres(deviation.max), covered);
}

/// The means of stretches of road: a point every two metres would be a picture of a megabyte.
std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> result;
  for (std::size_t i = 0; i < points.size();) {
    const double stretch = std::floor(points[i].x() / kChartStep);
    double sum = 0;
    std::size_t count = 0;
    for (; i < points.size() && std::floor(points[i].x() / kChartStep) == stretch; ++i, ++count) {
      sum += points[i].y();
    }
    result.emplace_back((stretch + 0.5) * kChartStep / 1000, 100 * sum / static_cast<double>(count));
  }
  return result;
}

}  // namespace

nlohmann::ordered_json to_json(const MapComparison& comparison) {
  nlohmann::ordered_json boundaries = nlohmann::ordered_json::array();
  for (const BoundaryComparison& boundary : comparison.boundaries) {
    nlohmann::ordered_json json = deviation_json(boundary.deviation);
    json["id"] = boundary.id;
    json["length_m"] = boundary.length;
    json["covered_m"] = boundary.covered;
    boundaries.push_back(std::move(json));
  }
  return {{"all", deviation_json(comparison.all)},
          {"covered_share", comparison.covered_share},
          {"strays", comparison.strays},
          {"boundaries", std::move(boundaries)}};
}

std::string to_table(const MapComparison& comparison) {
  std::string table = fmt::format("{:<10} {:>8} {:>8} {:>8} {:>8} {:>8}  {}\n", "boundary", "points",
                                  "mean [m]", "RMSE [m]", "p95 [m]", "max [m]", "covered");
  for (const BoundaryComparison& boundary : comparison.boundaries) {
    table += row(std::to_string(boundary.id), boundary.deviation,
                 fmt::format("{:.0f} of {:.0f} m", boundary.covered, boundary.length));
  }
  table += row("all", comparison.all, fmt::format("{:.1f} %", 100 * comparison.covered_share));
  if (comparison.strays > 0)
    table += fmt::format("{} points lie along no true boundary\n", comparison.strays);
  return table;
}

std::string to_chart(const MapComparison& comparison) {
  constexpr std::array kColours{"series-0", "series-1", "series-4", "series-2", "series-5", "series-3"};
  Chart chart{"Surveyed lines against the exact road", {}, {}, {}};
  double longest = 0;
  double largest = 1;
  for (const BoundaryComparison& boundary : comparison.boundaries) {
    const std::string colour = kColours[chart.series.size() % kColours.size()];
    chart.series.push_back(
        {fmt::format("boundary {}", boundary.id), thinned(boundary.points), colour, {}, false});
    for (const Eigen::Vector2d& point : chart.series.back().points) {
      longest = std::max(longest, point.x());
      largest = std::max(largest, std::abs(point.y()));
    }
  }
  chart.x = axis_from_zero("along the road [km]", longest, 10);
  const double step = nice_step(2 * largest, 8);
  const double reach = step * std::ceil(largest / step);
  chart.y = {"to the left [cm]", -reach, reach, step};
  return standalone_svg(draw_chart(chart));
}

}  // namespace lanefuse
