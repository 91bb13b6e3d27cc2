// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_as_map.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

std::uint64_t id_of(int index) { return static_cast<std::uint64_t>(index) + 1; }

/// Whole metres, and the ends.
std::vector<double> stations_of(const Stretch& stretch, double road_length) {
  const double begin = std::max(stretch.begin, 0.0);
  const double end = std::min(stretch.end, road_length);
  std::vector<double> stations{begin};
  for (double station = std::floor(begin) + 1; station < end; ++station) stations.push_back(station);
  if (end > begin) stations.push_back(end);
  return stations;
}

template <typename Lateral>
std::vector<Eigen::Vector3d> points_along(const Road& road, const Stretch& stretch, Lateral lateral) {
  std::vector<Eigen::Vector3d> points;
  for (const double station : stations_of(stretch, road.length())) {
    const Eigen::Vector2d place = road.pose(station, lateral(station)).position();
    points.emplace_back(place.x(), place.y(), 0);
  }
  return points;
}

/// Arc length [m] along points that stand at `stations_of(stretch)`, at a station.
double arc_length_at(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& stations,
                     double station) {
  double length = 0;
  for (std::size_t i = 1; i < points.size() && stations[i] <= station; ++i) {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

MapBoundary boundary_of(const Road& road, int index) {
  const RoadLine& line = road.parts().lines[static_cast<std::size_t>(index)];
  MapBoundary boundary{id_of(index), {}, {}};
  boundary.points = points_along(road, line.stretch, [&line](double s) { return line.lateral.at(s); });
  const std::vector<double> stations = stations_of(line.stretch, road.length());
  for (const PaintStyle& style : line.styles) {
    const bool first = boundary.styles.empty();
    const double from = first ? 0 : arc_length_at(boundary.points, stations, style.from);
    boundary.styles.push_back({from, style.marking, style.width});
  }
  return boundary;
}

/// The lane beside: the one with which this lane shares the line for longest.
std::optional<std::uint64_t> beside(const Road& road, int lane, Side side) {
  std::optional<std::uint64_t> found;
  double longest = 0;
  for (int other = 0; other < road.lane_count(); ++other) {
    const bool shares = side == Side::left ? road.right_line(other) == road.left_line(lane)
                                           : road.left_line(other) == road.right_line(lane);
    const double shared = std::min(road.lane_end(lane), road.lane_end(other)) -
                          std::max(road.lane_begin(lane), road.lane_begin(other));
    if (!shares || shared <= longest) continue;
    longest = shared;
    found = id_of(other);
  }
  return found;
}

/// Where this lane ends, others begin that continue it: they have the same place across the road.
std::vector<std::uint64_t> successors_of(const Road& road, int lane) {
  const double end = road.lane_end(lane);
  std::vector<std::uint64_t> successors;
  for (int other = 0; other < road.lane_count() && end < road.length(); ++other) {
    const bool continues = other != lane && road.lane_begin(other) == end && road.lane_width(lane, end) > 1 &&
                           std::abs(road.lane_centre(other, end) - road.lane_centre(lane, end)) < 1;
    if (continues) successors.push_back(id_of(other));
  }
  return successors;
}

void add_shoulder(const Road& road, const HardShoulder& shoulder, RoadMap& map) {
  const auto edge = [&](double s) { return road.line_lateral(shoulder.left_line, s) - shoulder.width; };
  MapBoundary boundary{map.boundaries.back().id + 1, points_along(road, shoulder.stretch, edge), {}};
  boundary.styles.push_back({0, {MarkingType::road_edge, MarkingColour::unknown}, 0.15});
  MapLane lane{
      map.lanes.back().id + 1, LaneKind::emergency, id_of(shoulder.left_line), boundary.id, {}, {}, {}};
  map.boundaries.push_back(std::move(boundary));
  map.lanes.push_back(std::move(lane));
}

}  // namespace

RoadMap road_map(const Road& road) {
  RoadMap map;
  for (int i = 0; i < road.line_count(); ++i) {
    if (!road.parts().lines[static_cast<std::size_t>(i)].ghost)
      map.boundaries.push_back(boundary_of(road, i));
  }
  for (int i = 0; i < road.lane_count(); ++i) {
    map.lanes.push_back({id_of(i), road.lane_kind(i), id_of(road.left_line(i)), id_of(road.right_line(i)),
                         beside(road, i, Side::left), beside(road, i, Side::right), successors_of(road, i)});
  }
  for (const HardShoulder& shoulder : road.parts().shoulders) add_shoulder(road, shoulder, map);
  return map;
}

TrueRoad true_road(const Road& road) {
  RoadMap map = road_map(road);
  std::erase_if(map.lanes, [](const MapLane& lane) { return lane.kind == LaneKind::emergency; });
  const auto bounds_a_lane = [&map](const MapBoundary& boundary) {
    return std::any_of(map.lanes.begin(), map.lanes.end(), [&boundary](const MapLane& lane) {
      return lane.left_boundary == boundary.id || lane.right_boundary == boundary.id;
    });
  };
  std::erase_if(map.boundaries, [&](const MapBoundary& boundary) { return !bounds_a_lane(boundary); });
  return true_road(map);
}

}  // namespace lanefuse
