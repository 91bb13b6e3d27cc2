// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_from_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "simulation/longest_lane_chain.hpp"
#include "simulation/reference_fit.hpp"
#include "simulation/road_projection.hpp"

namespace lanefuse {
namespace {

constexpr double kShortestRoad = 200;  ///< [m]
constexpr double kShortestLine = 10;   ///< [m]
constexpr double kRailSpacing = 50;    ///< [m] between knots of the guard rails
constexpr double kSmoothing = 15;      ///< [m] to either side over which the way along a lane is averaged
constexpr double kSnap = 5;            ///< [m] from the road's end, where a line ends with it

double length_of(const std::vector<Eigen::Vector2d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

ReferenceLine reference_of(const RoadMap& map, const std::string& place) {
  const std::vector<Eigen::Vector2d> chain = longest_lane_chain(map);
  const double length = chain.empty() ? 0 : length_of(chain);
  if (length < kShortestRoad) {
    throw input_error(place, fmt::format("has no driving lanes in a row of {} m; the longest is {:.0f} m",
                                         kShortestRoad, length));
  }
  std::optional<ReferenceLine> line = fit_reference_line(chain);
  if (line) return std::move(*line);
  throw input_error(place,
                    "has a longest row of driving lanes that turns too sharply to be driven as one road",
                    "cut the map down to a road whose bends are wider than 50 m");
}

/// A line of the road, not yet in its place among the others.
struct FoundLine {
  std::uint64_t boundary = 0;
  double mean_lateral = 0;
  RoadLine line;
};

/// How often lanes that are driven on have the boundary.
int lanes_at(const RoadMap& map, std::uint64_t boundary) {
  return static_cast<int>(std::count_if(map.lanes.begin(), map.lanes.end(), [boundary](const MapLane& lane) {
    return lane.kind != LaneKind::emergency &&
           (lane.left_boundary == boundary || lane.right_boundary == boundary);
  }));
}

PaintStyle style_of(const MarkingStyle& style, bool edge, const RoadPreset& preset) {
  PaintStyle paint{0, style.marking, style.width};
  if (paint.marking.type == MarkingType::unknown) {
    paint.marking.type = edge ? MarkingType::solid : MarkingType::dashed;
    paint.width = edge ? preset.edge_marking_width : preset.dashed_marking_width;
  }
  if (paint.marking.colour == MarkingColour::unknown) paint.marking.colour = MarkingColour::white;
  if (paint.marking.type != MarkingType::dashed) return paint;
  paint.mark = preset.dash_mark;
  paint.gap = preset.dash_gap;
  return paint;
}

bool is_paint(const PaintStyle& style) {
  return style.marking.type == MarkingType::solid || style.marking.type == MarkingType::dashed;
}

void paint(RoadLine& line, const MapBoundary& boundary, const std::vector<ProjectedPoint>& points, bool edge,
           const RoadPreset& preset) {
  for (std::size_t i = 0; i < boundary.styles.size(); ++i) {
    const auto station_of = [&points](double along) {
      const auto found =
          std::find_if(points.begin(), points.end(), [along](const auto& p) { return p.along >= along; });
      return found == points.end() ? points.back().station : found->station;
    };
    PaintStyle style = style_of(boundary.styles[i], edge, preset);
    style.from = station_of(boundary.styles[i].from);
    const bool last = i + 1 == boundary.styles.size();
    const double to = last ? line.stretch.end : station_of(boundary.styles[i + 1].from);
    if (!is_paint(style) && to > style.from) line.unpainted.push_back({style.from, to});
    line.styles.push_back(style);
  }
}

std::optional<FoundLine> line_of(const RoadMap& map, const MapBoundary& boundary,
                                 const ReferenceLine& reference, const RoadPreset& preset) {
  const std::vector<ProjectedPoint> points = project(reference, boundary);
  if (points.empty() || points.back().station - points.front().station < kShortestLine) return {};
  FoundLine found{boundary.id, 0, {}};
  for (const ProjectedPoint& point : points)
    found.mean_lateral += point.lateral / static_cast<double>(points.size());
  found.line.stretch = {points.front().station, points.back().station};
  if (found.line.stretch.begin < kSnap) found.line.stretch.begin = 0;
  if (reference.length() - found.line.stretch.end < kSnap) found.line.stretch.end = reference.length();
  found.line.lateral = course_through(points);
  paint(found.line, boundary, points, lanes_at(map, boundary.id) < 2, preset);
  return found;
}

std::vector<FoundLine> lines_of(const RoadMap& map, const ReferenceLine& reference,
                                const RoadPreset& preset) {
  std::vector<FoundLine> lines;
  for (const MapBoundary& boundary : map.boundaries) {
    if (lanes_at(map, boundary.id) == 0) continue;
    if (auto line = line_of(map, boundary, reference, preset)) lines.push_back(std::move(*line));
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const FoundLine& a, const FoundLine& b) { return a.mean_lateral > b.mean_lateral; });
  return lines;
}

/// The way along a lane: half-way between its lines, without their corners.
LateralCourse centre_of(const RoadLine& left, const RoadLine& right) {
  const double begin = std::max(left.stretch.begin, right.stretch.begin);
  const double end = std::min(left.stretch.end, right.stretch.end);
  const auto middle = [&](double station) {
    return (left.lateral.at(station) + right.lateral.at(station)) / 2;
  };
  std::vector<LateralCourse::Knot> knots;
  const double count = std::max(1.0, std::floor((end - begin) / (2 * kSmoothing)));
  for (double i = 0; i <= count; ++i) {
    const double station = begin + (end - begin) * i / count;
    const double reach = std::min({kSmoothing, station - begin, end - station});
    double sum = 0;
    for (int k = -5; k <= 5; ++k) sum += middle(station + reach * k / 5);
    knots.push_back({station, sum / 11, 0});
  }
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const LateralCourse::Knot& next = knots[i + 1];
    knots[i].slope = (next.lateral - knots[i - 1].lateral) / (next.station - knots[i - 1].station);
  }
  return LateralCourse(std::move(knots));
}

void add_lanes(const RoadMap& map, const std::map<std::uint64_t, int>& line_of_boundary, RoadParts& parts) {
  for (const MapLane& lane : map.lanes) {
    const auto left = line_of_boundary.find(lane.left_boundary);
    const auto right = line_of_boundary.find(lane.right_boundary);
    const bool found = left != line_of_boundary.end() && right != line_of_boundary.end();
    if (lane.kind == LaneKind::emergency || !found || left->second >= right->second) continue;
    const RoadLine& left_line = parts.lines[static_cast<std::size_t>(left->second)];
    const RoadLine& right_line = parts.lines[static_cast<std::size_t>(right->second)];
    const bool side_by_side = std::max(left_line.stretch.begin, right_line.stretch.begin) + kShortestLine <
                              std::min(left_line.stretch.end, right_line.stretch.end);
    if (!side_by_side) continue;
    parts.lanes.push_back({lane.kind, left->second, right->second, centre_of(left_line, right_line)});
  }
  std::stable_sort(parts.lanes.begin(), parts.lanes.end(),
                   [](const RoadLane& a, const RoadLane& b) { return a.left_line < b.left_line; });
}

/// Hard shoulders of the map, as wide as they are half-way.
void add_shoulders(const RoadMap& map, const ReferenceLine& reference,
                   const std::map<std::uint64_t, int>& line_of_boundary, RoadParts& parts) {
  for (const MapLane& lane : map.lanes) {
    const auto left = line_of_boundary.find(lane.left_boundary);
    if (lane.kind != LaneKind::emergency || left == line_of_boundary.end()) continue;
    const std::vector<ProjectedPoint> edge = project(reference, *find_boundary(map, lane.right_boundary));
    if (edge.empty()) continue;
    const RoadLine& line = parts.lines[static_cast<std::size_t>(left->second)];
    const ProjectedPoint& middle = edge[edge.size() / 2];
    const double width = line.lateral.at(middle.station) - middle.lateral;
    const Stretch stretch{std::max(line.stretch.begin, edge.front().station),
                          std::min(line.stretch.end, edge.back().station)};
    if (width > 0 && stretch.end > stretch.begin) parts.shoulders.push_back({left->second, stretch, width});
  }
}

/// Beyond the outermost line, with room for a shoulder.
LateralCourse rail_beside(const RoadParts& parts, int side, double road_length, const RoadPreset& preset) {
  std::vector<LateralCourse::Knot> knots;
  for (double station = 0; station < road_length; station += kRailSpacing) {
    double outermost = 0;
    for (const RoadLine& line : parts.lines) {
      if (line.stretch.holds(station)) outermost = std::max(outermost, side * line.lateral.at(station));
    }
    knots.push_back({station, side * (outermost + preset.shoulder + preset.guard_rail), 0});
  }
  return LateralCourse(std::move(knots));
}

}  // namespace

Road road_from_map(const RoadMap& map, const RoadPreset& preset, std::uint64_t seed,
                   const std::string& place) {
  check(map, place);
  ReferenceLine reference = reference_of(map, place);
  RoadParts parts;
  std::map<std::uint64_t, int> line_of_boundary;
  for (FoundLine& found : lines_of(map, reference, preset)) {
    line_of_boundary[found.boundary] = static_cast<int>(parts.lines.size());
    parts.lines.push_back(std::move(found.line));
  }
  add_lanes(map, line_of_boundary, parts);
  add_shoulders(map, reference, line_of_boundary, parts);
  if (parts.lanes.empty()) throw input_error(place, "has no lane beside its own longest one");
  parts.left_rail = rail_beside(parts, +1, reference.length(), preset);
  parts.right_rail = rail_beside(parts, -1, reference.length(), preset);
  Random heights(seed, "road height");
  RoadHeight height(preset, reference.length(), heights);
  return {std::move(reference), std::move(height), std::move(parts)};
}

}  // namespace lanefuse
