// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/road_map.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

template <typename Item>
const Item* find_by_id(const std::vector<Item>& items, std::uint64_t id) {
  const auto found =
      std::find_if(items.begin(), items.end(), [id](const Item& item) { return item.id == id; });
  return found == items.end() ? nullptr : &*found;
}

/// A thousand kilometres of a road with six lanes are a third of it. Beyond it two points would be enough to
/// fill the memory of whoever goes along a boundary step by step.
constexpr double kLongestInAll = 2e7;  // [m]

double length_of(const std::vector<Eigen::Vector3d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

/// The style that holds on most of the boundary.
const MarkingStyle& prevailing_style(const MapBoundary& boundary) {
  const double length = length_of(boundary.points);
  const MarkingStyle* prevailing = &boundary.styles.front();
  double longest = -1;
  for (std::size_t i = 0; i < boundary.styles.size(); ++i) {
    const double to = i + 1 < boundary.styles.size() ? boundary.styles[i + 1].from : length;
    if (to - boundary.styles[i].from <= longest) continue;
    longest = to - boundary.styles[i].from;
    prevailing = &boundary.styles[i];
  }
  return *prevailing;
}

void check_boundary(const MapBoundary& boundary, const std::string& place) {
  const std::string here = fmt::format("{}, boundary {}", place, boundary.id);
  if (boundary.points.size() < 2) throw input_error(here, "has fewer than two points");
  const bool finite = std::all_of(boundary.points.begin(), boundary.points.end(),
                                  [](const Eigen::Vector3d& point) { return point.allFinite(); });
  if (!finite) throw input_error(here, "has a point that is not finite");
  if (boundary.styles.empty() || boundary.styles.front().from != 0) {
    throw input_error(here, "has no marking style from its beginning on");
  }
  const bool in_order = std::is_sorted(boundary.styles.begin(), boundary.styles.end(),
                                       [](const auto& a, const auto& b) { return a.from < b.from; });
  if (!in_order) throw input_error(here, "has marking styles out of order");
}

/// Of its way in the plane.
double checked_length(const MapBoundary& boundary, const std::string& place) {
  double length = 0;
  for (std::size_t i = 1; i < boundary.points.size(); ++i) {
    length += (boundary.points[i] - boundary.points[i - 1]).head<2>().norm();
  }
  if (length > 0) return length;
  throw input_error(fmt::format("{}, boundary {}", place, boundary.id), "has no length");
}

using Ids = std::set<std::uint64_t>;

void check_lane(const MapLane& lane, const Ids& boundaries, const Ids& lanes, const std::string& place) {
  const std::string here = fmt::format("{}, lane {}", place, lane.id);
  for (const std::uint64_t boundary : {lane.left_boundary, lane.right_boundary}) {
    if (!boundaries.contains(boundary)) {
      throw input_error(here, fmt::format("refers to boundary {}, which is not there", boundary));
    }
  }
  std::vector<std::uint64_t> others = lane.successors;
  if (lane.left_lane) others.push_back(*lane.left_lane);
  if (lane.right_lane) others.push_back(*lane.right_lane);
  for (const std::uint64_t other : others) {
    if (!lanes.contains(other)) {
      throw input_error(here, fmt::format("refers to lane {}, which is not there", other));
    }
  }
}

template <typename Item>
Ids checked_ids(const std::vector<Item>& items, const char* what, const std::string& place) {
  Ids seen;
  for (const Item& item : items) {
    if (item.id == 0) throw input_error(place, fmt::format("a {} has the id 0", what));
    if (!seen.insert(item.id).second) {
      throw input_error(place, fmt::format("{} {} is there twice", what, item.id));
    }
  }
  return seen;
}

}  // namespace

const char* to_string(LaneKind kind) {
  switch (kind) {
    case LaneKind::driving:
      return "driving";
    case LaneKind::emergency:
      return "emergency";
    case LaneKind::entry:
      return "entry";
    case LaneKind::exit:
      return "exit";
    case LaneKind::other:
      return "other";
  }
  return "?";
}

const MarkingStyle& style_at(const MapBoundary& boundary, double arc_length) {
  const auto after = std::upper_bound(boundary.styles.begin(), boundary.styles.end(), arc_length,
                                      [](double at, const MarkingStyle& style) { return at < style.from; });
  return after == boundary.styles.begin() ? *after : *(after - 1);
}

const MapBoundary* find_boundary(const RoadMap& map, std::uint64_t id) {
  return find_by_id(map.boundaries, id);
}

const MapLane* find_lane(const RoadMap& map, std::uint64_t id) { return find_by_id(map.lanes, id); }

void check(const RoadMap& map, const std::string& place) {
  const Ids boundaries = checked_ids(map.boundaries, "boundary", place);
  const Ids lanes = checked_ids(map.lanes, "lane", place);
  double length = 0;
  for (const MapBoundary& boundary : map.boundaries) {
    check_boundary(boundary, place);
    length += checked_length(boundary, place);
    if (length <= kLongestInAll) continue;
    throw input_error(
        fmt::format("{}, boundary {}", place, boundary.id),
        fmt::format("brings the boundaries to more than {} km in all", std::lround(kLongestInAll / 1000)),
        "cut the map into smaller ones");
  }
  for (const MapLane& lane : map.lanes) check_lane(lane, boundaries, lanes, place);
}

TrueRoad true_road(const RoadMap& map) {
  TrueRoad road;
  for (const MapBoundary& boundary : map.boundaries) {
    const MarkingStyle& style = prevailing_style(boundary);
    TrueBoundary& truth =
        road.boundaries.emplace_back(TrueBoundary{boundary.id, style.marking, style.width, {}});
    truth.points.reserve(boundary.points.size());
    for (const Eigen::Vector3d& point : boundary.points) truth.points.push_back(point.head<2>());
  }
  const auto judged = [&map](std::optional<std::uint64_t> id) -> std::optional<std::uint64_t> {
    const MapLane* lane = id ? find_lane(map, *id) : nullptr;
    return lane && lane->kind != LaneKind::emergency ? id : std::nullopt;
  };
  for (const MapLane& lane : map.lanes) {
    if (lane.kind == LaneKind::emergency) continue;
    road.lanes.push_back(
        {lane.id, lane.left_boundary, lane.right_boundary, judged(lane.left_lane), judged(lane.right_lane)});
  }
  return road;
}

}  // namespace lanefuse
