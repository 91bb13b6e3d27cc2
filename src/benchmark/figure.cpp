// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/figure.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDistanceStep = 20;  ///< [m] between the distances shown
constexpr int kEntryStep = 10;     ///< [m] between the entries of a line's lists

void add_rmse(std::vector<BenchmarkFigure>& all, const std::string& lane) {
  for (int distance = 0; distance <= 120; distance += kDistanceStep) {
    const std::string entry = fmt::format("/lanes/{}/{}", lane, distance / kEntryStep);
    all.push_back({fmt::format("{} RMSE at {} m", lane, distance), "m", entry + "/rmse_m", entry + "/n",
                   BenchmarkFigure::Better::lower, BenchmarkFigure::Mean::root_square});
  }
}

std::vector<BenchmarkFigure> make_figures() {
  using Better = BenchmarkFigure::Better;
  using Mean = BenchmarkFigure::Mean;
  std::vector<BenchmarkFigure> all;
  add_rmse(all, "ego");
  add_rmse(all, "adjacent");
  all.insert(
      all.end(),
      {{"ego reaches 60 m", "", "/lanes/ego/6/availability", "", Better::higher, Mean::plain},
       {"adjacent reaches 60 m", "", "/lanes/adjacent/6/availability", "", Better::higher, Mean::plain},
       {"false lanes a frame", "", "/false_lanes_per_frame", "", Better::lower, Mean::plain},
       {"wrong-lane rate", "", "/wrong_lane_rate", "", Better::lower, Mean::plain},
       {"cycle time, median", "ms", "/cycle_ms/p50", "", Better::lower, Mean::plain},
       {"cycle time, 99th percentile", "ms", "/cycle_ms/p99", "", Better::lower, Mean::plain}});
  assert(all.size() == kFigureCount);
  return all;
}

std::optional<double> number_at(const Json& line, const std::string& pointer) {
  const Json::json_pointer where(pointer);
  if (!line.contains(where) || !line.at(where).is_number()) return std::nullopt;
  return line.at(where).get<double>();
}

}  // namespace

std::span<const BenchmarkFigure> figures() {
  static const std::vector<BenchmarkFigure> all = make_figures();
  return all;
}

std::size_t rmse_figure(bool adjacent, std::size_t shown_distance) {
  assert(shown_distance < kShownDistances);
  return (adjacent ? kShownDistances : 0) + shown_distance;
}

std::optional<double> value_of(const BenchmarkFigure& figure, const Json& line) {
  return number_at(line, figure.value);
}

std::optional<DriveSample> sample_of(const BenchmarkFigure& figure, const Json& line) {
  const std::optional<double> value = value_of(figure, line);
  const std::optional<double> weight = figure.weight.empty() ? 1 : number_at(line, figure.weight);
  if (!value || !weight || !(*weight > 0)) return std::nullopt;
  return DriveSample{figure.mean == BenchmarkFigure::Mean::root_square ? *value * *value : *value, *weight};
}

std::optional<FigureMean> mean_of(const BenchmarkFigure& figure, std::span<const Json* const> lines) {
  std::vector<DriveSample> samples;
  for (const Json* line : lines) {
    if (const auto sample = sample_of(figure, *line)) samples.push_back(*sample);
  }
  const auto mean = mean_of_drives(samples);
  if (!mean) return std::nullopt;
  const auto as_figure = [&figure](double value) {
    return figure.mean == BenchmarkFigure::Mean::root_square ? std::sqrt(std::max(0.0, value)) : value;
  };
  FigureMean result{as_figure(mean->mean), {}, {}, mean->drives};
  if (mean->half_width) {
    result.low = as_figure(mean->mean - *mean->half_width);
    result.high = as_figure(mean->mean + *mean->half_width);
  }
  return result;
}

}  // namespace lanefuse
