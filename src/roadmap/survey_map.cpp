// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_map.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "roadmap/survey_axis.hpp"
#include "roadmap/survey_line.hpp"
#include "roadmap/survey_yaw.hpp"

namespace lanefuse {
namespace {

constexpr double kStyleReach = 20;  ///< [m] to either side, over which paint is called by one name

SurveyAxis axis_of(std::span<const SurveyedDrive> drives, double step) {
  const auto longest = std::max_element(drives.begin(), drives.end(), [](const auto& a, const auto& b) {
    return length_of(a.track) < length_of(b.track);
  });
  return {longest->track, step};
}

/// Stations from `begin` up to `end` without a gap.
struct Run {
  std::size_t begin;
  std::size_t end;
};

std::vector<Run> runs_of(const StationSeries& series, std::size_t shortest) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!is_known(series[i])) continue;
    std::size_t end = i;
    while (end < series.size() && is_known(series[end])) ++end;
    if (end - i >= shortest) runs.push_back({i, end});
    i = end;
  }
  return runs;
}

/// Turns lines into boundaries and the gaps between them into lanes.
class MapMaking {
 public:
  MapMaking(const SurveyAxis& axis, std::span<const SurveyTrace> traces, const SurveyConfig& config)
      : axis_(axis), traces_(traces), config_(config) {}

  void add(const SurveyLine& line) {
    std::vector<Piece>& pieces = lines_.emplace_back();
    const auto paint = painted(line, traces_, stations(kStyleReach));
    for (const Run& run : runs_of(line.lateral, stations(config_.shortest_line))) {
      pieces.push_back({run, map_.boundaries.size() + 1});
      map_.boundaries.push_back(boundary(line, run, paint));
    }
    laterals_.push_back(line.lateral);
  }

  RoadMap finish() {
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i) add_lanes(i);
    link_neighbours();
    return std::move(map_);
  }

 private:
  struct Piece {
    Run run;
    std::uint64_t boundary;
  };
  const SurveyAxis& axis_;
  std::span<const SurveyTrace> traces_;
  const SurveyConfig& config_;
  RoadMap map_;
  std::vector<std::vector<Piece>> lines_;
  std::vector<StationSeries> laterals_;

  [[nodiscard]] std::size_t stations(double metres) const {
    return static_cast<std::size_t>(std::lround(metres / axis_.step()));
  }

  [[nodiscard]] Eigen::Vector3d point(const SurveyLine& line, std::size_t station) const {
    const Eigen::Vector2d place = axis_.knot(station) * Eigen::Vector2d(0, line.lateral[station]);
    return {place.x(), place.y(), axis_.height(station)};
  }

  [[nodiscard]] MapBoundary boundary(const SurveyLine& line, const Run& run,
                                     const std::vector<MarkingEvidence>& paint) const {
    MapBoundary boundary{map_.boundaries.size() + 1, {}, {}};
    double from = 0;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      boundary.points.push_back(point(line, i));
      const std::size_t count = boundary.points.size();
      if (count > 1) from += (boundary.points[count - 1] - boundary.points[count - 2]).norm();
      if (boundary.styles.empty() || !(boundary.styles.back().marking == paint[i])) {
        boundary.styles.push_back({from, paint[i], std::round(line.paint_width * 100) / 100});
      }
    }
    return boundary;
  }

  void add_lanes(std::size_t left_line) {
    std::optional<std::size_t> before;
    for (const Piece& left : lines_[left_line]) {
      for (const Piece& right : lines_[left_line + 1]) {
        if (!is_lane(left_line, left.run, right.run)) continue;
        map_.lanes.push_back(
            {map_.lanes.size() + 1, LaneKind::driving, left.boundary, right.boundary, {}, {}, {}});
        if (before) map_.lanes[*before].successors.push_back(map_.lanes.size());
        before = map_.lanes.size() - 1;
      }
    }
  }

  [[nodiscard]] bool is_lane(std::size_t left_line, const Run& left, const Run& right) const {
    const std::size_t begin = std::max(left.begin, right.begin);
    const std::size_t end = std::min(left.end, right.end);
    if (end < begin + stations(config_.shortest_line)) return false;
    double width = 0;
    for (std::size_t i = begin; i < end; ++i) width += laterals_[left_line][i] - laterals_[left_line + 1][i];
    width /= static_cast<double>(end - begin);
    return width >= config_.narrowest_lane && width <= config_.widest_lane;
  }

  /// Lanes that share a boundary lie side by side.
  void link_neighbours() {
    for (MapLane& left : map_.lanes) {
      for (MapLane& right : map_.lanes) {
        if (left.right_boundary != right.left_boundary || left.right_lane || right.left_lane) continue;
        left.right_lane = right.id;
        right.left_lane = left.id;
      }
    }
  }
};

std::vector<SurveyTrace> all_traces(std::span<const SurveyedDrive> drives, const SurveyAxis& axis,
                                    const std::vector<StationSeries>& yaws, const SurveyConfig& config) {
  std::vector<SurveyTrace> traces;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    auto some = traces_of({drives[i], i, axis, yaws[i]},
                          static_cast<std::size_t>(config.shortest_line / axis.step()));
    std::move(some.begin(), some.end(), std::back_inserter(traces));
  }
  return traces;
}

}  // namespace

RoadMap survey_map(std::span<const SurveyedDrive> drives, const GeoOrigin& origin,
                   const SurveyConfig& config) {
  if (drives.empty()) throw input_error("survey", "no drives");
  const SurveyAxis axis = axis_of(drives, config.station_step);
  std::vector<StationSeries> yaws(drives.size());
  std::vector<SurveyTrace> traces = all_traces(drives, axis, yaws, config);
  std::vector<SurveyLine> lines = lines_of(traces, config);
  merge_lines(traces, drives.size(), axis.step(), config, lines);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    yaws[i] = camera_yaw({drives[i], i, axis, yaws[i]}, lines, config.yaw_reach);
  }
  traces = all_traces(drives, axis, yaws, config);
  lines = lines_of(traces, config);
  if (lines.empty()) throw input_error("survey", "no drive follows a line for long enough");
  merge_lines(traces, drives.size(), axis.step(), config, lines);

  MapMaking making(axis, traces, config);
  for (SurveyLine& line : lines) {
    line.lateral = smoothed(line.lateral, static_cast<std::size_t>(config.smoothing_reach / axis.step()));
    fill_gaps(line.lateral, static_cast<std::size_t>(config.longest_gap / axis.step()));
    making.add(line);
  }
  RoadMap map = making.finish();
  map.name = fmt::format("survey of {} drives", drives.size());
  map.origin = origin;
  check(map, map.name);
  return map;
}

}  // namespace lanefuse
